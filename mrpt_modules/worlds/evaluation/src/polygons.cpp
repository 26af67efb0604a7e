// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "polygons.h"

#include <algorithm>
#include <cmath>

namespace traverse::evaluation
{
namespace
{
constexpr double kFar = std::numeric_limits<double>::infinity();

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}
}  // namespace

double areaOf(const Polygon& polygon)
{
  double twice = 0;
  for (size_t i = 0; i < polygon.size(); ++i)
  {
    twice += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  }
  return std::abs(twice) / 2;
}

double distanceTo(const Polygon& polygon, const Eigen::Vector2d& place)
{
  double nearest2 = kFar;
  bool left = false;
  bool right = false;
  for (size_t i = 0; i < polygon.size(); ++i)
  {
    const Eigen::Vector2d& from = polygon[i];
    const Eigen::Vector2d edge = polygon[(i + 1) % polygon.size()] - from;
    const double side = cross(edge, place - from);
    left = left || side > 0;
    right = right || side < 0;
    const double length2 = edge.squaredNorm();
    const double along =
        length2 > 0 ? std::clamp((place - from).dot(edge) / length2, 0.0, 1.0) : 0.0;
    nearest2 = std::min(nearest2, (place - from - along * edge).squaredNorm());
  }
  return left && right ? std::sqrt(nearest2) : 0;
}

double distanceToAny(const TrueOutline& outline, const Eigen::Vector2d& place)
{
  double nearest = kFar;
  for (const Polygon& polygon : outline.polygons)
  {
    nearest = std::min(nearest, distanceTo(polygon, place));
  }
  return nearest;
}

double areaOf(const TrueOutline& outline)
{
  double area_m2 = 0;
  for (const Polygon& polygon : outline.polygons)
  {
    area_m2 += areaOf(polygon);
  }
  return area_m2;
}

Box boxOf(const Polygon& polygon)
{
  Box box;
  for (const Eigen::Vector2d& p : polygon)
  {
    box.min = box.min.cwiseMin(p);
    box.max = box.max.cwiseMax(p);
  }
  return box;
}

Box boxOf(const TrueOutline& outline)
{
  Box box;
  for (const Polygon& polygon : outline.polygons)
  {
    const Box one = boxOf(polygon);
    box.min = box.min.cwiseMin(one.min);
    box.max = box.max.cwiseMax(one.max);
  }
  return box;
}

bool isUsable(const Polygon& polygon)
{
  return polygon.size() >= 3 && areaOf(polygon) > 0;
}
}  // namespace traverse::evaluation
