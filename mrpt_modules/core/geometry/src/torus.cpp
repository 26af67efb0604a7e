// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/geometry/torus.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace traverse::geometry
{
namespace
{
int32_t checkedEdge(int32_t edge)
{
  if (edge < 1 || edge > Torus::kLargestSide)
  {
    throw std::invalid_argument("a region's edge must have 1 to 16384 cells");
  }
  return edge;
}

CellRect squareAround(CellIndex centre, int32_t edge)
{
  const CellIndex first = {centre.x - edge / 2, centre.y - edge / 2};
  return {first, {first.x + edge, first.y + edge}};
}

/** The part of [min, max) that a shift leaves behind, and the part that it keeps. */
struct Split
{
  int32_t lost_min, lost_max, kept_min, kept_max;
};

Split splitBy(int32_t old_min, int32_t new_min, int32_t edge)
{
  return new_min >= old_min ? Split{old_min, new_min, new_min, old_min + edge}
                            : Split{new_min + edge, old_min + edge, old_min, new_min + edge};
}
}  // namespace

Torus::Torus(int32_t region_edge)
{
  const int64_t edge = checkedEdge(region_edge);
  int64_t side = 1;
  while (side * side <= 2 * edge * edge)
  {
    side *= 2;
    ++shift_;
  }
  mask_ = static_cast<int32_t>(side - 1);
}

RollingRegion::RollingRegion(int32_t edge) : rect_(squareAround({0, 0}, checkedEdge(edge))) {}

DroppedCells RollingRegion::moveTo(CellIndex centre)
{
  constexpr int32_t kFarthest = std::numeric_limits<int32_t>::max() - (1 << 15);
  if (std::max(std::abs(int64_t{centre.x}), std::abs(int64_t{centre.y})) > kFarthest)
  {
    throw std::invalid_argument("a region of cells may not lie beyond 2^31 - 2^15 cells");
  }
  const CellRect old = rect_;
  const int32_t edge = old.width();
  rect_ = squareAround(centre, edge);
  DroppedCells dropped;
  if (std::max(
          std::abs(int64_t{rect_.min.x} - old.min.x), std::abs(int64_t{rect_.min.y} - old.min.y)) >=
      edge)
  {
    dropped.add(old);
    return dropped;
  }
  const Split x = splitBy(old.min.x, rect_.min.x, edge);
  const Split y = splitBy(old.min.y, rect_.min.y, edge);
  dropped.add({{old.min.x, y.lost_min}, {old.max.x, y.lost_max}});  // whole rows
  dropped.add({{x.lost_min, y.kept_min}, {x.lost_max, y.kept_max}});
  return dropped;
}
}  // namespace traverse::geometry
