// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "open_near.h"

namespace traverse::app
{
using navigation::Passage;

std::optional<navigation::Goal> openNear(
    const navigation::Costmap& costmap, const navigation::Goal& goal)
{
  constexpr int32_t kReach_m = 4;
  const geometry::CellIndex middle = costmap.cellAt(goal.x_m, goal.y_m);
  const auto reach = static_cast<int32_t>(kReach_m / costmap.lattice.cell_m());
  std::optional<geometry::CellIndex> best;
  int32_t best_squared = reach * reach + 1;
  for (int32_t dy = -reach; dy <= reach; ++dy)
  {
    for (int32_t dx = -reach; dx <= reach; ++dx)
    {
      const geometry::CellIndex cell = {middle.x + dx, middle.y + dy};
      const int32_t squared = dx * dx + dy * dy;
      if (squared < best_squared && costmap.passageAt(cell) == Passage::open)
      {
        best = cell;
        best_squared = squared;
      }
    }
  }
  if (!best)
  {
    return std::nullopt;
  }
  return navigation::Goal{
      costmap.lattice.centre_m(best->x), costmap.lattice.centre_m(best->y), std::nullopt};
}
}  // namespace traverse::app
