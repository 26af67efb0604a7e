// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "beam_fans.h"
#include "cell_columns.h"
#include "cloud_frame.h"
#include "ground_reference.h"
#include "paper_lidar.h"
#include "rules.h"

#include <traverse/multi_lidar_grid/unit_map.h>

#include <vector>

namespace traverse::multi_lidar_grid
{
/** What a UnitMapper works with. */
struct UnitMapper::Work
{
  Work(const Params& params, const geometry::Vehicle& vehicle);

  void locatePoints(
      const Cloud& cloud, const SensorParams& sensor, const geometry::CellRect& region);
  void findGround(const Cloud& cloud, const geometry::CellRect& region);
  void judgeCells(UnitMap& map);
  void traceFans(const Cloud& cloud, const SensorParams& sensor, UnitMap& map);
  void tracePaper(const Cloud& cloud, UnitMap& map);
  void finish(UnitMap& map) const;
  bool passedBetween(int32_t x, int32_t y, float from_m, float to_m);
  geometry::CellIndex cellOf(int32_t column_cell, const geometry::CellRect& region) const;

  Rules rules;
  geometry::Lattice lattice;
  GroundReference ground;
  BeamFrame frame;
  BeamPoints points;
  CellColumns columns;
  BeamFans fans;
  std::vector<Eigen::Vector3f> origins;  // of the fans of the last cloud, none of paper's trace
  PaperLidar paper;
  const LocalGround* local_ground = nullptr;
  bool is_level = false;
  int32_t obstacle_mm = 0;  // for this sensor
};
}  // namespace traverse::multi_lidar_grid
