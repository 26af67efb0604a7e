// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "projection.h"

#include <traverse/traversability_grid/traversability_grid.h>

#include <algorithm>
#include <span>
#include <stdexcept>

namespace traverse::traversability_grid
{
namespace
{
/** An empty map takes the options as they are now; one with points must have been made with the
 * same lattice. */
void adopt(State& state, const Params& params, const geometry::Vehicle& vehicle)
{
  const Division division = divisionOf(params, vehicle);
  if (!state.empty() && !(division == Division{state.lattice, state.slab_mm}))
  {
    throw std::invalid_argument(
        "a traversability grid with points keeps its cell_size_m and slab height; clear it first");
  }
  state.lattice = division.lattice;
  state.slab_mm = division.slab_mm;
  state.slabs.setMost(mostSlabs(params));
  if (!(state.rule == classRule(params, vehicle)))
  {
    reclassify(state, params, vehicle);
  }
}

/** What this scan's coming makes the map forget. */
void makeRoom(State& state, const geometry::CellRect& neighbourhood, const Params& params)
{
  if (params.mode == Mode::single_cloud)
  {
    clearCells(state);
  }
  if (params.mode == Mode::single_cloud || params.extent == Extent::rolling)
  {
    moveWindow(state, neighbourhood);
  }
  else
  {
    state.window.reset();
  }
}

/** Steps 1 to 3 for one scan by itself, a block of points after the other. */
void collect(
    State& state,
    const points::Scan& scan,
    const Projection& projection,
    const Params& params,
    layers::UpdateStats& stats)
{
  const uint32_t most_points = ScanSlab::mostPoints(state.lattice.cell_mm, state.slab_mm);
  state.scan.begin(projection.accepted(), {most_points, mostTiles(params)}, scan.size());
  LatticePoints points;
  for (size_t first = 0; first < scan.size(); first += points.size)
  {
    projection.project(scan, first, points, stats);
    state.scan.add(points);
  }
  stats.over_budget += state.scan.refused();
}

/** Steps 4 to 6 for the cells of the last scan, with all that the map knows of them. */
void judgeTouched(
    State& state,
    const geometry::CellRect& window,
    const Params& params,
    const geometry::Vehicle& vehicle)
{
  judgeCells(state, state.touched, window, params, vehicle, state.judge);
  const std::span<const Judgement> judgements = state.judge.judgements();
  for (size_t i = 0; i < judgements.size(); ++i)
  {
    setClass(state.cells.at(state.touched[i]), judgements[i], params);  // step 6
  }
}

void rememberRobot(State& state, poses::TimeNs stamp, const Eigen::Isometry3d& T_map_base)
{
  if (!state.robot || stamp >= state.robot->time)
  {
    state.robot = poses::StampedPose{stamp, T_map_base};
  }
}
}  // namespace

void advance(State& state, poses::TimeNs now, const Params& params)
{
  if (forgets(params))
  {
    forgetUnseen(state, now, params);
  }
}

layers::UpdateStats update(
    State& state,
    const points::Scan& scan,
    const Eigen::Isometry3d& T_map_base,
    const Params& params,
    const geometry::Vehicle& vehicle)
{
  layers::UpdateStats stats;
  adopt(state, params, vehicle);
  const std::optional<Projection> projection = Projection::at(T_map_base, state, params);
  stats.no_pose = !projection;
  if (!projection)
  {
    state.scan.begin({}, {}, 0);  // no labels of the scan before
    state.touched.clear();
    return stats;
  }
  collect(state, scan, *projection, params, stats);  // steps 1 to 3
  if (state.scan.empty())
  {
    state.touched.clear();
    return stats;
  }
  makeRoom(state, projection->neighbourhood(), params);
  rememberRobot(state, scan.stamp, T_map_base);
  advance(state, state.robot->time, params);
  const uint32_t sensor = sensorBit(state, scan.sensor_label);
  addToMap(state, ScanSource(scan, T_map_base, sensor, params), params, stats);
  stats.touched_cells = state.touched.size();
  stats.inserted = stats.points > 0;
  state.driven.add(T_map_base, vehicle);
  judgeTouched(state, projection->accepted(), params, vehicle);  // steps 4 to 6
  return stats;
}
}  // namespace traverse::traversability_grid
