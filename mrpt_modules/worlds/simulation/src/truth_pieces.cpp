// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "truth_pieces.h"

#include "clip.h"

#include <algorithm>
#include <cmath>

namespace traverse::simulation
{
namespace
{
/** How far something solid must reach into a sub-square to stand there: what ends on its edge does
 * not. (Loose sheets may have no thickness at all: they count where they touch.) */
constexpr double kReach_m = 0.0005;

/** First and last column (row) that [min_m, max_m], counted from the grid's edge, touches; none
 * where last < first. */
struct Span
{
  int first = 0;
  int last = -1;
};

Span spanOf(double min_m, double max_m, double sub_m, int count)
{
  const double first = std::floor(min_m / sub_m);
  const double last = std::floor(max_m / sub_m);
  if (!(last >= 0 && first < count))
  {
    return {};
  }
  return {static_cast<int>(std::max(first, 0.0)), static_cast<int>(std::min(last, count - 1.0))};
}
}  // namespace

void Pieces::add(const Object& object, uint32_t number, double at_s)
{
  checkTriangles(object);
  const Eigen::Isometry3d T_map_body = object.motion.at(at_s);
  for (const Part& part : object.parts)
  {
    addPart(part, T_map_body, {number, pieces_++, yields(part.material), part.solid});
  }
  for (const Ball& ball : object.balls)
  {
    addBall(ball, T_map_body, {number, pieces_++, yields(ball.material), true});
  }
}

void Pieces::addPart(const Part& part, const Eigen::Isometry3d& T_map_body, Filling filling)
{
  std::vector<Eigen::Vector3d> vertices;
  vertices.reserve(part.vertices.size());
  const Eigen::Vector3d origin(grid_.minX_m(), grid_.minY_m(), 0);
  for (const Eigen::Vector3f& vertex : part.vertices)
  {
    vertices.emplace_back(T_map_body * vertex.cast<double>() - origin);
  }
  for (const std::array<uint32_t, 3>& triangle : part.triangles)
  {
    addTriangle({vertices[triangle[0]], vertices[triangle[1]], vertices[triangle[2]]}, filling);
  }
}

void Pieces::addTriangle(const std::array<Eigen::Vector3d, 3>& corners, const Filling& filling)
{
  const Clipped whole(corners);
  if (!whole.finite())
  {
    return;
  }
  const double sub_m = grid_.sub_m();
  const double reach_m = filling.solid ? kReach_m : 0.0;
  const Limits y = whole.along(1);
  const Span rows = spanOf(y.min, y.max, sub_m, grid_.height());
  for (int row = rows.first; row <= rows.last; ++row)
  {
    const Clipped strip = whole.between(1, row * sub_m + reach_m, (row + 1) * sub_m - reach_m);
    if (strip.empty())
    {
      continue;
    }
    const Limits x = strip.along(0);
    const Span columns = spanOf(x.min, x.max, sub_m, grid_.width());
    for (int column = columns.first; column <= columns.last; ++column)
    {
      const Clipped inside =
          strip.between(0, column * sub_m + reach_m, (column + 1) * sub_m - reach_m);
      if (!inside.empty())
      {
        const Limits z = inside.along(2);
        put(grid_.at(column, row), z.min, z.max, filling);
      }
    }
  }
}

void Pieces::addBall(const Ball& ball, const Eigen::Isometry3d& T_map_body, const Filling& filling)
{
  const Eigen::Vector3d centre =
      T_map_body * ball.centre.cast<double>() - Eigen::Vector3d(grid_.minX_m(), grid_.minY_m(), 0);
  const double radius_m = ball.radius_m;
  if (!(radius_m > 0) || !centre.allFinite())
  {
    return;
  }
  const double sub_m = grid_.sub_m();
  const Span rows = spanOf(centre.y() - radius_m, centre.y() + radius_m, sub_m, grid_.height());
  const Span columns = spanOf(centre.x() - radius_m, centre.x() + radius_m, sub_m, grid_.width());
  const auto outside = [&](double c, int i) {
    return std::max({i * sub_m + kReach_m - c, c - (i + 1) * sub_m + kReach_m, 0.0});
  };
  for (int row = rows.first; row <= rows.last; ++row)
  {
    for (int column = columns.first; column <= columns.last; ++column)
    {
      // highest and lowest where the sub-square is nearest to the ball's axis
      const double dx = outside(centre.x(), column);
      const double dy = outside(centre.y(), row);
      const double up2 = radius_m * radius_m - dx * dx - dy * dy;
      if (up2 > 0)
      {
        const double up = std::sqrt(up2);
        put(grid_.at(column, row), centre.z() - up, centre.z() + up, filling);
      }
    }
  }
}

void Pieces::put(size_t sub, double lo_m, double hi_m, const Filling& filling)
{
  const auto lo = static_cast<float>(lo_m);
  const auto hi = static_cast<float>(hi_m);
  const uint32_t newest = first_[sub];
  // pieces are added one after the other, so the newest interval is the piece's own or another's
  if (newest != Interval::kNone && intervals_[newest].piece == filling.piece)
  {
    Interval& own = intervals_[newest];
    if (filling.solid || (lo <= own.hi_m && hi >= own.lo_m))
    {
      own.lo_m = std::min(own.lo_m, lo);
      own.hi_m = std::max(own.hi_m, hi);
      return;
    }
  }
  first_[sub] = static_cast<uint32_t>(intervals_.size());
  intervals_.push_back({lo, hi, filling.object, filling.piece, newest, filling.yields});
}
}  // namespace traverse::simulation
