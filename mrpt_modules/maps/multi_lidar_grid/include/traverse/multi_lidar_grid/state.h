// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/lattice.h>
#include <traverse/layers/occupancy_state.h>
#include <traverse/layers/wrapped_grid.h>
#include <traverse/multi_lidar_grid/params.h>
#include <traverse/multi_lidar_grid/sensors.h>
#include <traverse/multi_lidar_grid/unit_map.h>
#include <traverse/poses/pose_track.h>

#include <cstdint>
#include <optional>

namespace traverse::multi_lidar_grid
{
/** One cell of the accumulated map. */
struct Cell
{
  layers::OccupancyState state = layers::OccupancyState::unknown;
  uint8_t passes = 0;  //!< looks in a row that contradicted an obstacle

  /** In steps of kFreeStep_m over the ground: free cells: known free up to here; obstacles: hit up
   * to here. */
  uint8_t up_to = 0;
  uint8_t hit_from = 0;  //!< obstacles: hit from here on, in the same steps

  /** accumulation = log_odds: the log-odds of an obstacle, in steps of kLogOddsStep; = sweeps: the
   * share of looks that hit it lately, in 127ths. */
  int8_t belief = 0;

  uint32_t seen_by = 0;         //!< bits of the sensors that said what it is
  poses::TimeNs last_hit = 0;   //!< of an obstacle, negative or overhang
  poses::TimeNs last_seen = 0;  //!< of anything said of it
};

static_assert(sizeof(Cell) == 32);

inline constexpr double kLogOddsStep = 0.1;

/** The map as a value. */
struct State
{
  State(const Params& params, const geometry::Vehicle& vehicle);

  geometry::Lattice lattice;
  layers::WrappedGrid<Cell> cells;  //!< the accumulated map
  Sensors sensors;                  //!< and the latest cloud of each
  UnitMapper mapper;
  std::optional<poses::StampedPose> robot;  //!< newest pose that a cloud came with
  poses::TimeNs now = 0;                    //!< newest stamp, or what advance() said
  poses::TimeNs forgot_at = 0;              //!< when cells were last looked through for old ones

  bool empty() const { return !robot; }
};
}  // namespace traverse::multi_lidar_grid
