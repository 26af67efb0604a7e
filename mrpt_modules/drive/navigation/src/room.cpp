// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "room.h"

#include <cmath>
#include <limits>

namespace traverse::navigation
{
using geometry::CellIndex;

double roomAt(const Costmap& costmap, CellIndex c, int32_t reach_cells)
{
  int64_t nearest = std::numeric_limits<int64_t>::max();
  const geometry::CellRect around = geometry::intersection(
      {{c.x - reach_cells, c.y - reach_cells}, {c.x + reach_cells + 1, c.y + reach_cells + 1}},
      costmap.extent);
  for (CellIndex h = around.min; h.y < around.max.y; ++h.y)
  {
    for (h.x = around.min.x; h.x < around.max.x; ++h.x)
    {
      const int64_t dx = int64_t{h.x} - c.x;
      const int64_t dy = int64_t{h.y} - c.y;
      if (dx * dx + dy * dy < nearest && costmap.passage[costmap.indexOf(h)] >= Passage::hard)
      {
        nearest = dx * dx + dy * dy;
      }
    }
  }
  return nearest == std::numeric_limits<int64_t>::max()
             ? std::numeric_limits<double>::infinity()
             : std::sqrt(static_cast<double>(nearest)) * costmap.lattice.cell_m();
}
}  // namespace traverse::navigation
