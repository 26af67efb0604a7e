// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/navigation/costmap.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

// Whether a convex outline touches obstacle cells, the plain way: an axis that separates it from
// the square of each cell (with libm; nothing of the planner's).
namespace traverse::testing
{
using navigation::Passage;
using Corner = std::array<double, 2>;

inline std::vector<Corner> outlineAt(const geometry::Vehicle& vehicle, const geometry::Pose2& pose)
{
  std::vector<Corner> corners;
  for (size_t k = 0; k < vehicle.footprint_xs_m.size(); ++k)
  {
    const double x = vehicle.footprint_xs_m[k];
    const double y = vehicle.footprint_ys_m[k];
    corners.push_back(
        {pose.x_m + x * std::cos(pose.yaw_rad) - y * std::sin(pose.yaw_rad),
         pose.y_m + x * std::sin(pose.yaw_rad) + y * std::cos(pose.yaw_rad)});
  }
  return corners;
}

/** The corners of one lie beside those of the other by more than `deep_m` less than touching. */
inline bool isApartAlong(
    Corner axis, const std::vector<Corner>& a, const std::vector<Corner>& b, double deep_m)
{
  const auto reach = [&](const std::vector<Corner>& corners)
  {
    Corner interval = {
        std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const Corner& c : corners)
    {
      const double along = c[0] * axis[0] + c[1] * axis[1];
      interval = {std::min(interval[0], along), std::max(interval[1], along)};
    }
    return interval;
  };
  const Corner p = reach(a);
  const Corner q = reach(b);
  return p[1] < q[0] + deep_m || q[1] < p[0] + deep_m;
}

inline bool areApart(const std::vector<Corner>& a, const std::vector<Corner>& b, double deep_m)
{
  for (const std::vector<Corner>* shape : {&a, &b})
  {
    for (size_t k = 0; k < shape->size(); ++k)
    {
      const Corner& from = (*shape)[k];
      const Corner& to = (*shape)[(k + 1) % shape->size()];
      const double length = std::hypot(to[0] - from[0], to[1] - from[1]);
      const Corner axis = {(to[1] - from[1]) / length, (from[0] - to[0]) / length};
      if (isApartAlong(axis, a, b, deep_m))
      {
        return true;
      }
    }
  }
  return false;
}

/** Some obstacle cell reaches more than `deep_m` into the outline. */
inline bool touchesObstacle(
    const navigation::Costmap& map,
    const geometry::Vehicle& vehicle,
    const geometry::Pose2& pose,
    double deep_m)
{
  const std::vector<Corner> outline = outlineAt(vehicle, pose);
  const double cell_m = map.lattice.cell_m();
  Corner least = outline.front();
  Corner most = outline.front();
  for (const Corner& c : outline)
  {
    least = {std::min(least[0], c[0]), std::min(least[1], c[1])};
    most = {std::max(most[0], c[0]), std::max(most[1], c[1])};
  }
  for (double x0 = (std::floor(least[0] / cell_m) - 1) * cell_m; x0 < most[0] + cell_m;
       x0 += cell_m)
  {
    for (double y0 = (std::floor(least[1] / cell_m) - 1) * cell_m; y0 < most[1] + cell_m;
         y0 += cell_m)
    {
      const double x1 = x0 + cell_m;
      const double y1 = y0 + cell_m;
      const Passage passage = map.passageAt(map.cellAt((x0 + x1) / 2, (y0 + y1) / 2));
      if (passage == Passage::obstacle &&
          !areApart(outline, {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, deep_m))
      {
        return true;
      }
    }
  }
  return false;
}

/** No corner of an outline, given counter-clockwise, turns right. */
inline bool isConvex(const std::vector<Corner>& outline)
{
  for (size_t k = 0; k < outline.size(); ++k)
  {
    const Corner& a = outline[k];
    const Corner& b = outline[(k + 1) % outline.size()];
    const Corner& c = outline[(k + 2) % outline.size()];
    if ((b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]) <= 0)
    {
      return false;
    }
  }
  return true;
}
}  // namespace traverse::testing
