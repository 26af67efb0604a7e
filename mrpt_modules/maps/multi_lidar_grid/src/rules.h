// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/vehicle.h>
#include <traverse/multi_lidar_grid/params.h>

#include <cmath>
#include <cstdint>

namespace traverse::multi_lidar_grid
{
/** The options in the units of the work. */
struct Rules
{
  CellRule cells = CellRule::standard;
  TraceRule trace = TraceRule::standard;
  int32_t cell_mm = 200;
  int32_t obstacle_mm = 250;
  int32_t robot_mm = 2000;
  int32_t depth_mm = 0;
  double max_slope = 0;  //!< up per along
  double clearing_range_m = 0;
  float ditch_range_m = 0;

  Rules(const Params& params, const geometry::Vehicle& vehicle);

  float cell_m() const { return static_cast<float>(cell_mm) / 1000; }

  float obstacle_m() const { return static_cast<float>(obstacle_mm) / 1000; }

  float robot_m() const { return static_cast<float>(robot_mm) / 1000; }

  float depth_m() const { return static_cast<float>(depth_mm) / 1000; }

  bool needsGround() const { return cells == CellRule::standard || trace == TraceRule::standard; }
};
}  // namespace traverse::multi_lidar_grid
