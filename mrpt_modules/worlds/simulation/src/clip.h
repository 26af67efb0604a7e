// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace traverse::simulation
{
struct Limits
{
  double min = 0;
  double max = 0;
};

/** A triangle cut by planes across x and y (Sutherland and Hodgman, 1974). */
class Clipped
{
 public:
  explicit Clipped(const std::array<Eigen::Vector3d, 3>& corners)
  {
    for (const Eigen::Vector3d& corner : corners)
    {
      push({corner.x(), corner.y(), corner.z()});
    }
  }

  bool empty() const { return count_ == 0; }

  bool finite() const
  {
    return std::all_of(
        corners_.begin(), corners_.begin() + static_cast<ptrdiff_t>(count_),
        [](const Corner& p)
        { return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]); });
  }

  /** visit(x, y) for every corner. */
  template <class Visit>
  void forEachCorner(Visit&& visit) const
  {
    for (size_t i = 0; i < count_; ++i)
    {
      visit(corners_[i][0], corners_[i][1]);
    }
  }

  /** Smallest and largest coordinate; not of an empty one. */
  Limits along(size_t axis) const
  {
    Limits limits = {corners_[0][axis], corners_[0][axis]};
    for (size_t i = 1; i < count_; ++i)
    {
      limits.min = std::min(limits.min, corners_[i][axis]);
      limits.max = std::max(limits.max, corners_[i][axis]);
    }
    return limits;
  }

  /** What lies within [from, to] of an axis. */
  Clipped between(size_t axis, double from, double to) const
  {
    const Limits own = along(axis);
    if (own.min >= from && own.max <= to)
    {
      return *this;
    }
    if (own.max < from || own.min > to)
    {
      return Clipped();
    }
    return cut(axis, from, 1).cut(axis, to, -1);
  }

 private:
  using Corner = std::array<double, 3>;

  // three corners, and one more for each of four planes
  static constexpr size_t kMost = 8;

  Clipped() = default;

  void push(const Corner& corner)
  {
    if (count_ < kMost)
    {
      corners_[count_++] = corner;
    }
  }

  /** The side of the plane on which side * (coordinate - at) >= 0. */
  Clipped cut(size_t axis, double at, double side) const
  {
    Clipped rest;
    for (size_t i = 0; i < count_; ++i)
    {
      const Corner& p = corners_[i];
      const Corner& q = corners_[i + 1 == count_ ? 0 : i + 1];
      const double p_in = side * (p[axis] - at);
      const double q_in = side * (q[axis] - at);
      if (p_in >= 0)
      {
        rest.push(p);
      }
      if ((p_in >= 0) != (q_in >= 0))
      {
        const double t = p_in / (p_in - q_in);
        rest.push({p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]), p[2] + t * (q[2] - p[2])});
      }
    }
    return rest;
  }

  std::array<Corner, kMost> corners_{};
  size_t count_ = 0;
};
}  // namespace traverse::simulation
