// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "random_plot.h"

#include "refuse.h"

#include <traverse/geometry/exact_trig.h>

#include <algorithm>
#include <cmath>

namespace traverse::simulation
{
namespace
{
constexpr double kCorner_m = 2;

/** Half of the way's corners, from the middle outward. */
std::vector<Eigen::Vector2d> outward(
    Eigen::Vector2d at, double heading_rad, double bend, double more_bend, double half_m)
{
  constexpr double kStraightFrom_m = 30;
  std::vector<Eigen::Vector2d> corners;
  const int n = static_cast<int>(half_m / kCorner_m);
  corners.reserve(static_cast<size_t>(n));
  for (int i = 0; i < n; ++i)
  {
    const double along = kCorner_m * (i + 0.5);
    heading_rad += kCorner_m * (bend + more_bend * std::min(along, kStraightFrom_m));
    const auto [s, c] = geometry::sinCosOf(heading_rad);
    at += kCorner_m * Eigen::Vector2d(c, s);
    corners.emplace_back(at);
  }
  return corners;
}
}  // namespace

double inMillimetres(double value)
{
  return std::floor(value * 1000 + 0.5) / 1000;
}

Way::Way(Random& random, double half_m) : half_m_(half_m)
{
  constexpr double kOff_m = 3.5;
  const double heading = random.uniform(-geometry::kPi, geometry::kPi);
  const bool bends = random.chance(0.7);
  const double bend = bends ? random.uniform(-0.016, 0.016) : 0;
  const double more = bends ? random.uniform(-0.0005, 0.0005) : 0;
  const double off_x = random.uniform(-kOff_m, kOff_m);
  const Eigen::Vector2d middle(off_x, random.uniform(-kOff_m, kOff_m));
  std::vector<double> xs;
  std::vector<double> ys;
  const auto add = [&](const Eigen::Vector2d& p)
  {
    xs.push_back(inMillimetres(p.x()));
    ys.push_back(inMillimetres(p.y()));
  };
  // backwards a left bend is one to the right
  std::vector<Eigen::Vector2d> back = outward(middle, heading + geometry::kPi, -bend, more, half_m);
  std::for_each(back.rbegin(), back.rend(), add);
  add(middle);
  const std::vector<Eigen::Vector2d> ahead = outward(middle, heading, bend, more, half_m);
  std::for_each(ahead.begin(), ahead.end(), add);
  line_ = lineThrough(xs, ys, "the way");
  half_m_ = lengthOf(line_) / 2;
}

Way::Way(const std::pair<std::vector<double>, std::vector<double>>& corners) :
    line_(lineThrough(corners.first, corners.second, "the way"))
{
  half_m_ = lengthOf(line_) / 2;
}

Eigen::Vector2d Way::place(double along_m, double left_m) const
{
  const Eigen::Vector2d unit = segmentAt(line_, along_m + half_m_).unit;
  return placeAlong(line_, along_m + half_m_) + left_m * Eigen::Vector2d(-unit.y(), unit.x());
}

double Way::yawDeg(double along_m) const
{
  const Eigen::Vector2d unit = segmentAt(line_, along_m + half_m_).unit;
  return geometry::angleOf(unit.y(), unit.x()) * (180 / geometry::kPi);
}

double Way::distanceTo(const Eigen::Vector2d& place) const
{
  return std::sqrt(alongLine(line_, lengthOf(line_), place).square_m2);
}

std::pair<std::vector<double>, std::vector<double>> Way::beside(
    double from_m, double to_m, double left_m) const
{
  std::pair<std::vector<double>, std::vector<double>> corners;
  const int n = std::max(1, static_cast<int>((to_m - from_m) / kCorner_m));
  for (int i = 0; i <= n; ++i)
  {
    const Eigen::Vector2d p = place(from_m + (to_m - from_m) * i / n, left_m);
    corners.first.push_back(inMillimetres(p.x()));
    corners.second.push_back(inMillimetres(p.y()));
  }
  return corners;
}

bool Plot::isFree(const Disc& disc, double from_way_m) const
{
  const double x = disc.middle.x();
  const double y = disc.middle.y();
  const double r = disc.radius_m;
  const bool inside = x - r >= extent_.min_x_m && x + r <= extent_.max_x_m &&
                      y - r >= extent_.min_y_m && y + r <= extent_.max_y_m;
  return inside && way_.distanceTo(disc.middle) >= from_way_m + r &&
         std::none_of(
             taken_.begin(), taken_.end(),
             [&](const Disc& t)
             {
               const Eigen::Vector2d d = t.middle - disc.middle;
               const double apart = t.radius_m + r;
               return d.dot(d) < apart * apart;
             });
}

bool Plot::areFree(const std::vector<Disc>& discs, double from_way_m) const
{
  return std::all_of(
      discs.begin(), discs.end(), [&](const Disc& d) { return isFree(d, from_way_m); });
}

void Plot::take(const std::vector<Disc>& discs)
{
  taken_.insert(taken_.end(), discs.begin(), discs.end());
}

void checkDrive(const SceneParams& scene)
{
  constexpr double kBorder_m = 2;
  const SceneExtentParams& e = scene.extent;
  for (size_t i = 0; i < scene.drive_xs_m.size(); ++i)
  {
    const double x = scene.drive_xs_m[i];
    const double y = scene.drive_ys_m[i];
    const bool inside = x >= e.min_x_m + kBorder_m && x <= e.max_x_m - kBorder_m &&
                        y >= e.min_y_m + kBorder_m && y <= e.max_y_m - kBorder_m;
    if (!inside)
    {
      refuse(
          "drive_m", scene.random.drive_m,
          "a way that fits into the area of [Scene] wherever it begins (20 m less than its sides)");
    }
  }
}

std::vector<Disc> discsAlong(
    const std::vector<double>& xs_m, const std::vector<double>& ys_m, double radius_m)
{
  const std::vector<Segment> line = lineThrough(xs_m, ys_m, "corners");
  const double way = lengthOf(line);
  const int n = std::max(1, static_cast<int>(std::ceil(way / std::max(0.2, radius_m))));
  std::vector<Disc> discs;
  discs.reserve(static_cast<size_t>(n) + 1);
  for (int i = 0; i <= n; ++i)
  {
    discs.push_back({placeAlong(line, way * i / n), radius_m});
  }
  return discs;
}
}  // namespace traverse::simulation
