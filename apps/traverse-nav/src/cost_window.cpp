// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cost_window.h"

#include <cmath>

namespace traverse::app
{
geometry::CellRect around(
    const geometry::Pose2& pose, const geometry::Lattice& lattice, double window_m)
{
  const auto half = static_cast<int32_t>(std::ceil(window_m / lattice.cell_m() / 2));
  const geometry::CellIndex middle =
      lattice.cellOf(geometry::toMillimetres(pose.x_m), geometry::toMillimetres(pose.y_m));
  return {{middle.x - half, middle.y - half}, {middle.x + half, middle.y + half}};
}

geometry::CellRect windowOf(
    const geometry::CellRect& extent, const geometry::Lattice& from, const geometry::Lattice& to)
{
  const auto first = [&](int32_t cell)
  { return static_cast<int32_t>(geometry::floorDiv(int64_t{cell} * from.cell_mm, to.cell_mm)); };
  const auto end = [&](int32_t cell)
  { return static_cast<int32_t>(-geometry::floorDiv(-int64_t{cell} * from.cell_mm, to.cell_mm)); };
  return {{first(extent.min.x), first(extent.min.y)}, {end(extent.max.x), end(extent.max.y)}};
}
}  // namespace traverse::app
