// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/evaluation/outlines.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace traverse::evaluation
{
struct Box
{
  Eigen::Vector2d min = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d max = Eigen::Vector2d::Constant(-std::numeric_limits<double>::infinity());

  /** A lower bound of the distance to what is within. */
  double distanceTo(const Eigen::Vector2d& p) const
  {
    return (min - p).cwiseMax(p - max).cwiseMax(0.0).norm();
  }
};

Box boxOf(const Polygon& polygon);
Box boxOf(const TrueOutline& outline);

/** Whoever wrote the outlines, what is computed from them has an end. */
class Work
{
 public:
  /** `what` is there too much of, where it is too much. */
  explicit Work(std::string what) : what_(std::move(what)) {}

  /** Throws std::length_error beyond the limit. */
  void spend(uint64_t more)
  {
    constexpr uint64_t kMost = 200'000'000;
    done_ += more;
    if (done_ > kMost)
    {
      throw std::length_error(what_);
    }
  }

 private:
  std::string what_;
  uint64_t done_ = 0;
};

/** From the nearest of the polygons; 0 within one. */
double distanceToAny(const TrueOutline& outline, const Eigen::Vector2d& place);

/** Sum over the polygons. */
double areaOf(const TrueOutline& outline);

/** Three corners and an area: to distanceTo() all the world lies within others. */
bool isUsable(const Polygon& polygon);

/** Calls f(place) along the polygons' edges, at most a step apart (or 10000 an edge). */
template <class F>
void forEachEdgePlace(const TrueOutline& outline, double step_m, const F& f)
{
  constexpr double kMostPlaces = 10000;
  for (const Polygon& polygon : outline.polygons)
  {
    for (size_t i = 0; i < polygon.size(); ++i)
    {
      const Eigen::Vector2d& from = polygon[i];
      const Eigen::Vector2d way = polygon[(i + 1) % polygon.size()] - from;
      const int steps =
          static_cast<int>(std::clamp(std::ceil(way.norm() / step_m), 1.0, kMostPlaces));
      for (int k = 0; k < steps; ++k)
      {
        f(Eigen::Vector2d(from + way * k / steps));
      }
    }
  }
}
}  // namespace traverse::evaluation
