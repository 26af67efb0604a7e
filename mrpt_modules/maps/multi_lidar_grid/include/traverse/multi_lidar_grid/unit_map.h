// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/lattice.h>
#include <traverse/layers/occupancy_state.h>
#include <traverse/layers/wrapped_grid.h>
#include <traverse/multi_lidar_grid/cloud.h>
#include <traverse/multi_lidar_grid/params.h>

#include <cstdint>
#include <memory>

namespace traverse::multi_lidar_grid
{
/** What one cloud says of one cell. */
struct UnitCell
{
  layers::OccupancyState state = layers::OccupancyState::unknown;
  uint8_t returns = 0;  //!< in it, those above the vehicle's height left out; 255: or more
  /** In steps of kFreeStep_m over the ground: free cells: beams passed up to here; obstacles: hit
   * up to here. */
  uint8_t up_to = 0;
  uint8_t hit_from = 0;  //!< obstacles: hit from here on, in the same steps
};

inline constexpr double kFreeStep_m = 0.05;

/** One sensor's latest cloud as a map; on the cells of the accumulated map, so that cell and cell
 * lie at the same place of memory. */
struct UnitMap
{
  explicit UnitMap(int32_t region_edge) : cells(region_edge) {}

  poses::TimeNs stamp = 0;
  geometry::CellRect touched;  //!< nothing outside is known
  layers::WrappedGrid<UnitCell> cells;
};

/** The ground's height where sensors met it, on patches that roll with the robot. */
class GroundReference;

/** Turns clouds into unit maps (paper 5, steps 1 to 3). Has work space, and what it knows of the
 * ground, which all sensors share. */
class UnitMapper
{
 public:
  UnitMapper(const Params& params, const geometry::Vehicle& vehicle);
  UnitMapper(const UnitMapper& other);
  UnitMapper(UnitMapper&& other) noexcept;
  UnitMapper& operator=(UnitMapper other) noexcept;
  ~UnitMapper();

  /** Points of a cloud. */
  struct Counts
  {
    uint64_t points = 0;   //!< that fell into cells
    uint64_t outside = 0;  //!< beyond the region, the sensor's range or its field of view
    uint64_t bad_points = 0;
  };

  /** Makes the unit map of a cloud, around `centre`. Bad points are skipped and counted.
   *
   * A 2-D scanner's beams pass at one height: they free the cells they pass, up to that height
   * (up_to), and what they meet is an obstacle if it stands higher than half of it. */
  Counts make(
      const Cloud& cloud, const SensorParams& sensor, geometry::CellIndex centre, UnitMap& map);

  /** Whether a beam of the cloud that `map` was just made of went on through a cell between two
   * heights over the ground. Never with trace = paper. */
  bool passedBetween(
      const UnitMap& map, geometry::CellIndex cell, double from_m, double to_m) const;

  /** Height of the ground in a cell, m, map frame; NaN where it is not known. */
  double groundAt(geometry::CellIndex cell) const;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};
}  // namespace traverse::multi_lidar_grid
