// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/lattice.h>
#include <traverse/multi_lidar_grid/params.h>

#include <algorithm>
#include <cmath>

// How a map with some options divides space.
namespace traverse::multi_lidar_grid
{
inline geometry::Lattice latticeOf(const Params& params)
{
  return {static_cast<int32_t>(geometry::toMillimetres(params.cell_size_m))};
}

/** Cells along the region's edge. */
inline int32_t regionEdge(const Params& params)
{
  return std::max(1, static_cast<int32_t>(std::lround(params.window_m / params.cell_size_m)));
}
}  // namespace traverse::multi_lidar_grid
