// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "smooth_line.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace traverse::simulation
{
namespace
{
using Points = std::vector<Eigen::Vector2d>;

constexpr double kLongestMetres = 1e5;
constexpr double kFineMetres = 0.01;

Points pointsOf(const std::vector<double>& xs_m, const std::vector<double>& ys_m)
{
  if (xs_m.empty() || xs_m.size() != ys_m.size())
  {
    throw std::invalid_argument(
        "[Drive] xs_m and ys_m must hold as many numbers each, one at least");
  }
  Points points;
  points.reserve(xs_m.size());
  for (size_t i = 0; i < xs_m.size(); ++i)
  {
    points.emplace_back(xs_m[i], ys_m[i]);
  }
  return points;
}

/** Lengths of the straight pieces between the points. */
std::vector<double> chordsOf(const Points& points)
{
  std::vector<double> chords;
  chords.reserve(points.size());
  double sum = 0;
  for (size_t i = 1; i < points.size(); ++i)
  {
    const Eigen::Vector2d d = points[i] - points[i - 1];
    chords.push_back(std::sqrt(d.x() * d.x() + d.y() * d.y()));
    sum += chords.back();
    if (!(chords.back() > kFineMetres) || !(sum < kLongestMetres))
    {
      throw std::invalid_argument(
          "the points of [Drive] xs_m and ys_m must be 1 cm apart at least, and their line no "
          "longer than "
          "100 km");
    }
  }
  return chords;
}

/** The second derivatives at the points (Thomas' algorithm for the natural spline's equations). */
Points bendsOf(const Points& points, const std::vector<double>& chords)
{
  const size_t n = points.size();
  Points bends(n, Eigen::Vector2d::Zero());
  Points right(n, Eigen::Vector2d::Zero());
  std::vector<double> upper(n, 0);
  for (size_t i = 1; i + 1 < n; ++i)
  {
    const Eigen::Vector2d change =
        (points[i + 1] - points[i]) / chords[i] - (points[i] - points[i - 1]) / chords[i - 1];
    const double pivot = 2 * (chords[i - 1] + chords[i]) - chords[i - 1] * upper[i - 1];
    upper[i] = chords[i] / pivot;
    right[i] = (6 * change - chords[i - 1] * right[i - 1]) / pivot;
  }
  for (size_t i = n - 1; i-- > 1;)
  {
    bends[i] = right[i] - upper[i] * bends[i + 1];
  }
  return bends;
}

/** One piece of the spline, 0 <= f <= 1 along it. */
struct Piece
{
  Eigen::Vector2d p0, p1, bend0, bend1;
  double chord;

  Eigen::Vector2d place(double f) const
  {
    const double g = 1 - f;
    return g * p0 + f * p1 +
           chord * chord / 6 * ((g * g * g - g) * bend0 + (f * f * f - f) * bend1);
  }

  Eigen::Vector2d heading(double f) const
  {
    const double g = 1 - f;
    const Eigen::Vector2d d =
        (p1 - p0) / chord + chord / 6 * ((1 - 3 * g * g) * bend0 + (3 * f * f - 1) * bend1);
    const double length = std::sqrt(d.x() * d.x() + d.y() * d.y());
    return length > 0 ? Eigen::Vector2d(d / length) : Eigen::Vector2d::UnitX();
  }
};

SmoothLine::Place between(const SmoothLine::Place& a, const SmoothLine::Place& b, double fraction)
{
  const Eigen::Vector2d h = (1 - fraction) * a.heading + fraction * b.heading;
  const double length = std::sqrt(h.x() * h.x() + h.y() * h.y());
  return {
      (1 - fraction) * a.p + fraction * b.p,
      length > 0 ? Eigen::Vector2d(h / length) : Eigen::Vector2d(a.heading)};
}

/** All pieces of a line, walked in centimetres. */
class Spline
{
 public:
  explicit Spline(Points points) :
      points_(std::move(points)), chords_(chordsOf(points_)), bends_(bendsOf(points_, chords_))
  {
  }

  bool hasLength() const { return !chords_.empty(); }

  SmoothLine::Place begin() const
  {
    return {points_.front(), hasLength() ? piece(0).heading(0) : Eigen::Vector2d::UnitX()};
  }

  template <class F>
  void walk(F&& visit_place) const
  {
    for (size_t i = 0; i < chords_.size(); ++i)
    {
      const auto parts = static_cast<int>(std::ceil(chords_[i] / kFineMetres));
      for (int part = 1; part <= parts; ++part)
      {
        const double f = static_cast<double>(part) / parts;
        visit_place(SmoothLine::Place{piece(i).place(f), piece(i).heading(f)});
      }
    }
  }

 private:
  Piece piece(size_t i) const
  {
    return {points_[i], points_[i + 1], bends_[i], bends_[i + 1], chords_[i]};
  }

  Points points_;
  std::vector<double> chords_;
  Points bends_;
};

double wayBetween(const SmoothLine::Place& a, const SmoothLine::Place& b)
{
  const Eigen::Vector2d d = b.p - a.p;
  return std::sqrt(d.x() * d.x() + d.y() * d.y());
}
}  // namespace

SmoothLine::SmoothLine(const std::vector<double>& xs_m, const std::vector<double>& ys_m)
{
  const Spline spline(pointsOf(xs_m, ys_m));
  places_.push_back(spline.begin());
  Place last = spline.begin();
  spline.walk(
      [&](const Place& next)
      {
        length_m_ += wayBetween(last, next);
        last = next;
      });
  const auto steps = static_cast<size_t>(std::ceil(length_m_ / kLongestStepMetres));
  step_m_ = steps > 0 ? length_m_ / static_cast<double>(steps) : kLongestStepMetres;
  places_.reserve(steps + 1);
  double done_m = 0;
  last = places_.front();
  spline.walk(
      [&](const Place& next)
      {
        const double way_m = wayBetween(last, next);
        double due_m = static_cast<double>(places_.size()) * step_m_;
        for (; due_m <= done_m + way_m && places_.size() < steps;
             due_m = static_cast<double>(places_.size()) * step_m_)
        {
          places_.push_back(between(last, next, (due_m - done_m) / way_m));
        }
        done_m += way_m;
        last = next;
      });
  if (spline.hasLength())
  {
    places_.push_back(last);
  }
}

double SmoothLine::indexAt(double s_m) const
{
  const double index = std::clamp(s_m, 0.0, length_m_) / step_m_;
  return std::min(index, static_cast<double>(places_.size() - 1));
}

SmoothLine::Place SmoothLine::at(double s_m) const
{
  const double index = indexAt(s_m);
  const auto before = static_cast<size_t>(index);
  const size_t behind = std::min(before + 1, places_.size() - 1);
  return between(places_[before], places_[behind], index - static_cast<double>(before));
}
}  // namespace traverse::simulation
