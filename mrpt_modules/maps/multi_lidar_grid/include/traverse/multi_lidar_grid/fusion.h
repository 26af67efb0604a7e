// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/lattice.h>
#include <traverse/layers/occupancy_state.h>
#include <traverse/multi_lidar_grid/params.h>
#include <traverse/multi_lidar_grid/state.h>

#include <cstdint>
#include <vector>

namespace traverse::multi_lidar_grid
{
/** What the latest clouds say together, row-major in a rectangle of cells. */
struct LatestMap
{
  geometry::CellRect extent;
  std::vector<uint8_t> states;    //!< codes of layers::OccupancyState
  std::vector<uint32_t> seen_by;  //!< a bit of each sensor whose latest cloud knows the cell
};

/** Fuses the latest unit map of each sensor whose health counts() at state.now, by
 * stronger(). Cells outside the map are unknown. */
LatestMap fuseLatest(const State& state, const Params& params, const geometry::CellRect& window);
}  // namespace traverse::multi_lidar_grid
