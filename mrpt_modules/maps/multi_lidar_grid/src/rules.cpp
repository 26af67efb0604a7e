// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rules.h"

#include <traverse/geometry/exact_trig.h>
#include <traverse/geometry/lattice.h>

#include <limits>

namespace traverse::multi_lidar_grid
{
namespace
{
int32_t millimetres(double metres)
{
  return static_cast<int32_t>(geometry::toMillimetres(metres));
}
}  // namespace

Rules::Rules(const Params& params, const geometry::Vehicle& vehicle) :
    cells(params.cells),
    trace(params.trace),
    cell_mm(millimetres(params.cell_size_m)),
    obstacle_mm(millimetres(params.obstacle_height_m)),
    robot_mm(millimetres(vehicle.height_m)),
    depth_mm(millimetres(params.negative_depth_m)),
    max_slope(geometry::tangentOf(vehicle.max_slope_deg * geometry::kPi / 180)),
    clearing_range_m(params.clearing_range_m),
    ditch_range_m(
        params.negative_range_m > 0 ? static_cast<float>(params.negative_range_m)
                                    : std::numeric_limits<float>::infinity())
{
}
}  // namespace traverse::multi_lidar_grid
