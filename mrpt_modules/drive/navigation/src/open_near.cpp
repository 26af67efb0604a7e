// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/navigation/open_near.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace traverse::navigation
{
namespace
{
using geometry::CellIndex;

bool isPassed(const Costmap& costmap, CellIndex cell)
{
  const Passage passage = costmap.passageAt(cell);
  return costmap.extent.contains(cell) &&
         (passage == Passage::open || passage == Passage::soft ||
          (passage == Passage::unknown && costmap.is_unknown_planned));
}

/** 1 for each cell that hangs together with the vehicle's own, or with those around it where it
 * stands too near to something. */
std::vector<uint8_t> reachedFrom(const Costmap& costmap, CellIndex start)
{
  constexpr double kWayOut_m = 1;
  constexpr std::array<CellIndex, 4> kSides = {{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
  std::vector<uint8_t> is_reached(costmap.size(), 0);
  std::vector<CellIndex> waiting;
  const auto reach = [&](CellIndex cell)
  {
    if (isPassed(costmap, cell) && is_reached[costmap.indexOf(cell)] == 0)
    {
      is_reached[costmap.indexOf(cell)] = 1;
      waiting.push_back(cell);
    }
  };
  const auto out =
      static_cast<int32_t>(isPassed(costmap, start) ? 0 : kWayOut_m / costmap.lattice.cell_m());
  for (int32_t i = 0; i < (2 * out + 1) * (2 * out + 1); ++i)
  {
    reach({start.x + i % (2 * out + 1) - out, start.y + i / (2 * out + 1) - out});
  }
  while (!waiting.empty())
  {
    const CellIndex cell = waiting.back();
    waiting.pop_back();
    for (const CellIndex side : kSides)
    {
      reach({cell.x + side.x, cell.y + side.y});
    }
  }
  return is_reached;
}

int64_t squaredCells(CellIndex a, CellIndex b)
{
  const int64_t dx = int64_t{a.x} - b.x;
  const int64_t dy = int64_t{a.y} - b.y;
  return dx * dx + dy * dy;
}
}  // namespace

std::optional<Goal> openNear(
    const Costmap& costmap, const Goal& goal, const geometry::Pose2& vehicle)
{
  const CellIndex at_goal = costmap.cellAt(goal.x_m, goal.y_m);
  const CellIndex start = costmap.cellAt(vehicle.x_m, vehicle.y_m);
  const auto near = static_cast<int64_t>(kNearGoal_m / costmap.lattice.cell_m());
  const std::vector<uint8_t> is_reached = reachedFrom(costmap, start);
  std::optional<CellIndex> best;
  int64_t best_squared = std::max(near * near + 1, squaredCells(start, at_goal));
  for (CellIndex c = costmap.extent.min; c.y < costmap.extent.max.y; ++c.y)
  {
    for (c.x = costmap.extent.min.x; c.x < costmap.extent.max.x; ++c.x)
    {
      const size_t i = costmap.indexOf(c);
      const int64_t squared = squaredCells(c, at_goal);
      if (squared < best_squared && is_reached[i] != 0 && costmap.passage[i] == Passage::open)
      {
        best = c;
        best_squared = squared;
      }
    }
  }
  if (!best)
  {
    return std::nullopt;
  }
  return Goal{costmap.lattice.centre_m(best->x), costmap.lattice.centre_m(best->y), std::nullopt};
}
}  // namespace traverse::navigation
