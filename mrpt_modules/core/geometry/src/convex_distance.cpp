// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/geometry/convex_distance.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace traverse::geometry
{
namespace
{
constexpr double kInfinite = std::numeric_limits<double>::infinity();

double lengthOf(const Eigen::Vector2d& v)
{
  return std::sqrt(v.x() * v.x() + v.y() * v.y());
}

/** The two ends of an outline's i-th edge. */
std::pair<Eigen::Vector2d, Eigen::Vector2d> edgeOf(const Outline& outline, size_t i)
{
  return {outline[i], outline[i + 1 == outline.size() ? 0 : i + 1]};
}

double toEdge(const Eigen::Vector2d& place, const std::pair<Eigen::Vector2d, Eigen::Vector2d>& edge)
{
  const Eigen::Vector2d way = edge.second - edge.first;
  const Eigen::Vector2d to = place - edge.first;
  const double along = std::clamp(to.dot(way) / way.dot(way), 0.0, 1.0);
  return lengthOf(to - along * way);
}

/** How far all of b lies outside of one of a's edges: the most of them; negative: of none. */
double outside(const Outline& a, const Outline& b)
{
  double most = -kInfinite;
  for (size_t i = 0; i < a.size(); ++i)
  {
    const auto [from, to] = edgeOf(a, i);
    const Eigen::Vector2d way = to - from;
    const Eigen::Vector2d normal = Eigen::Vector2d(way.y(), -way.x()) / lengthOf(way);
    double least = kInfinite;
    for (const Eigen::Vector2d& corner : b)
    {
      least = std::min(least, normal.dot(corner - from));
    }
    most = std::max(most, least);
  }
  return most;
}

double cornersToEdges(const Outline& corners, const Outline& edges)
{
  double nearest = kInfinite;
  for (size_t i = 0; i < edges.size(); ++i)
  {
    const auto edge = edgeOf(edges, i);
    for (const Eigen::Vector2d& corner : corners)
    {
      nearest = std::min(nearest, toEdge(corner, edge));
    }
  }
  return nearest;
}
}  // namespace

double apart(const Outline& a, const Outline& b)
{
  const double gap = std::max(outside(a, b), outside(b, a));
  return gap < 0 ? gap : std::min(cornersToEdges(a, b), cornersToEdges(b, a));
}

double apart(const Eigen::Vector2d& place, const Outline& outline)
{
  const double gap = outside(outline, {place});
  return gap < 0 ? gap : cornersToEdges({place}, outline);
}

Round roundOf(const Outline& outline)
{
  Eigen::Vector2d min = outline.front();
  Eigen::Vector2d max = outline.front();
  for (const Eigen::Vector2d& corner : outline)
  {
    min = min.cwiseMin(corner);
    max = max.cwiseMax(corner);
  }
  Round round{(min + max) / 2, 0};
  for (const Eigen::Vector2d& corner : outline)
  {
    round.radius_m = std::max(round.radius_m, lengthOf(corner - round.middle));
  }
  return round;
}
}  // namespace traverse::geometry
