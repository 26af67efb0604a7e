// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "division.h"

#include <traverse/multi_lidar_grid/accumulate.h>
#include <traverse/multi_lidar_grid/multi_lidar_grid.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace traverse::multi_lidar_grid
{
namespace
{
void tuneClock(
    Sensor& sensor,
    const points::Scan& scan,
    const poses::PoseTrack& track,
    const Params& params,
    const geometry::Vehicle& vehicle)
{
  const SensorParams own = sensorParams(params, sensor.label);
  if (own.is_offset_given || !params.estimate_clock_offsets)
  {
    sensor.clock_offset_s = own.clock_offset_s;
    return;
  }
  const double ground_m = -vehicle.base_height_m;
  sensor.clock.add(
      scan, track, ground_m + 2 * params.obstacle_height_m, ground_m + vehicle.height_m);
  sensor.clock_offset_s = sensor.clock.estimate_s().value_or(sensor.clock_offset_s);
}

/** Newer than any before: the region follows the robot. */
void followRobot(State& state, const Cloud& cloud)
{
  state.now = std::max(state.now, cloud.stamp);
  if (state.robot && cloud.stamp < state.robot->time)
  {
    return;
  }
  state.robot = poses::StampedPose{cloud.stamp, cloud.path.pose()};
  const Eigen::Vector3d p = state.robot->T_map_base.translation();
  state.cells.moveTo(
      state.lattice.cellOf(geometry::toMillimetres(p.x()), geometry::toMillimetres(p.y())));
}

geometry::CellIndex middleOf(const geometry::CellRect& rect)
{
  return {rect.min.x + rect.width() / 2, rect.min.y + rect.height() / 2};
}

/** A pose that cells can be counted from. */
bool isOnLattice(const State& state, const Eigen::Isometry3d& T_map_base)
{
  constexpr double kMostCells = 1 << 30;
  return T_map_base.matrix().allFinite() &&
         T_map_base.translation().cwiseAbs().maxCoeff() <
             std::min(geometry::kFarthest_m, kMostCells * state.lattice.cell_m());
}
}  // namespace

State::State(const Params& params, const geometry::Vehicle& vehicle) :
    lattice(latticeOf(params)),
    cells(regionEdge(params)),
    mapper((check(params, vehicle), params), vehicle)
{
}

layers::OccupancyState stronger(layers::OccupancyState a, layers::OccupancyState b)
{
  using layers::OccupancyState;
  constexpr std::array<OccupancyState, 5> kByStrength = {
      OccupancyState::obstacle, OccupancyState::negative, OccupancyState::overhang,
      OccupancyState::free, OccupancyState::unknown};
  return *std::find_if(
      kByStrength.begin(), kByStrength.end() - 1,
      [&](OccupancyState state) { return state == a || state == b; });
}

layers::UpdateStats update(
    State& state,
    const points::Scan& scan,
    const poses::PoseTrack& track,
    const Params& params,
    const geometry::Vehicle& vehicle)
{
  layers::UpdateStats stats;
  Sensor& sensor = state.sensors.obtain(scan.sensor_label, state.cells.region().width());
  tuneClock(sensor, scan, track, params, vehicle);

  // The vehicle's pose at the cloud's own time, whatever other sensors do.
  const poses::TimeNs stamp = poses::later(scan.stamp, sensor.clock_offset_s);
  const std::optional<SensorPath> path = SensorPath::along(scan, stamp, track);
  stats.no_pose = !path || !isOnLattice(state, path->pose());
  if (stats.no_pose ||
      arrive(sensor, scan, stamp, path->pose().translation(), params) != Refusal::none)
  {
    return stats;
  }
  const Cloud cloud{scan, stamp, state.sensors.bitOf(sensor), *path};
  followRobot(state, cloud);

  // Steps 1 to 3: the cloud by itself, on the cells of the accumulated map.
  const UnitMapper::Counts counts = state.mapper.make(
      cloud, sensorParams(params, sensor.label), middleOf(state.cells.region()), sensor.latest);
  sensor.has_cloud = true;

  // The latest unit map into the running one.
  Accumulator(params).add(state.cells, sensor.latest, state.mapper, cloud.sensor_bit);
  advance(state, state.now, params);

  stats.points = counts.points;
  stats.outside = counts.outside;
  stats.bad_points = counts.bad_points;
  stats.inserted = true;
  return stats;
}

void advance(State& state, poses::TimeNs now, const Params& params)
{
  constexpr double kLooks = 8;  // in forget_after_s
  state.now = std::max(state.now, now);
  const bool is_time =
      poses::secondsBetween(state.forgot_at, state.now) > params.forget_after_s / kLooks;
  if (params.forget_after_s <= 0 || !is_time)
  {
    return;
  }
  state.forgot_at = state.now;
  state.cells.forEach(
      [&](geometry::CellIndex, Cell& cell)
      {
        if (poses::secondsBetween(cell.last_seen, state.now) > params.forget_after_s)
        {
          cell = Cell{};
        }
      });
}
}  // namespace traverse::multi_lidar_grid
