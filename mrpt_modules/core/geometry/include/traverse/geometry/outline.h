// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/vehicle.h>

#include <Eigen/Core>

#include <vector>

namespace traverse::geometry
{
/** Corners of a polygon, one after the other, m. */
using Outline = std::vector<Eigen::Vector2d>;

/** The vehicle's, in its frame; corners that lack x or y are left out. */
Outline footprintOf(const Vehicle& vehicle);

/** Half of the width of the box along the vehicle's axes that its footprint lies in, m; 0 where it
 * has no corner. */
double halfWidth_m(const Vehicle& vehicle);

/** Twice the area of the triangle, positive where it goes round counter-clockwise: on which side of
 * the way from a to b the place c lies. */
inline double turnOf(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c)
{
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/** The convex hull of points, counter-clockwise from the least x (of those, the least y); empty
 * where they span no area. Andrew's monotone chain (1979). */
Outline convexHull(std::vector<Eigen::Vector2d> points);

/** True inside, whichever way round the corners go; on the outline itself either. */
bool contains(const Outline& outline, const Eigen::Vector2d& place);
}  // namespace traverse::geometry
