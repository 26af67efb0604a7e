// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/geometry/outline.h>

#include <algorithm>
#include <utility>

namespace traverse::geometry
{
Outline footprintOf(const Vehicle& vehicle)
{
  Outline corners;
  const size_t count = std::min(vehicle.footprint_xs_m.size(), vehicle.footprint_ys_m.size());
  for (size_t i = 0; i < count; ++i)
  {
    corners.emplace_back(vehicle.footprint_xs_m[i], vehicle.footprint_ys_m[i]);
  }
  return corners;
}

double halfWidth_m(const Vehicle& vehicle)
{
  const auto& ys = vehicle.footprint_ys_m;
  const auto [right, left] = std::minmax_element(ys.begin(), ys.end());
  return ys.empty() ? 0 : (*left - *right) / 2;
}

Outline convexHull(std::vector<Eigen::Vector2d> points)
{
  const auto before = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b)
  { return std::make_pair(a.x(), a.y()) < std::make_pair(b.x(), b.y()); };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  Outline hull;
  const auto extend = [&](const Eigen::Vector2d& p, size_t least)
  {
    while (hull.size() >= least && turnOf(hull[hull.size() - 2], hull.back(), p) <= 0)
    {
      hull.pop_back();
    }
    hull.push_back(p);
  };
  for (const Eigen::Vector2d& p : points)
  {
    extend(p, 2);
  }
  const size_t lower = hull.size() + 1;
  for (size_t i = points.size(); i-- > 1;)
  {
    extend(points[i - 1], lower);
  }
  if (hull.size() < 4)  // the first corner stands at the end, too
  {
    return {};
  }
  hull.pop_back();
  return hull;
}

bool contains(const Outline& outline, const Eigen::Vector2d& place)
{
  // A ray along x to +infinity crosses the outline an odd number of times from inside.
  bool is_inside = false;
  for (size_t i = 0; i < outline.size(); ++i)
  {
    const Eigen::Vector2d& a = outline[i];
    const Eigen::Vector2d& b = outline[(i + 1) % outline.size()];
    if ((a.y() > place.y()) == (b.y() > place.y()))
    {
      continue;
    }
    const double crossing_m = a.x() + (place.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    is_inside = is_inside != (place.x() < crossing_m);
  }
  return is_inside;
}
}  // namespace traverse::geometry
