// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/exact_trig.h>
#include <traverse/multi_lidar_grid/unit_map.h>
#include <traverse/points/scan.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace traverse::testing
{
/** A world of boxes on a ground, small enough to say where everything is. */
struct DrawnWorld
{
  struct Box
  {
    Eigen::Vector3d min;
    Eigen::Vector3d max;
  };

  std::function<double(double, double)> ground = [](double, double) { return 0.0; };
  std::vector<Box> boxes;

  /** Range of the first thing that a beam meets within 100 m. */
  std::optional<double> cast(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const
  {
    double nearest = castGround(from, to);
    for (const Box& box : boxes)
    {
      nearest = std::min(nearest, castBox(box, from, to));
    }
    return nearest < kFar ? std::optional(nearest) : std::nullopt;
  }

 private:
  static constexpr double kFar = 100;

  double over(const Eigen::Vector3d& p) const { return p.z() - ground(p.x(), p.y()); }

  /** Steps shorter than the way to the ground; the ground rises in steps only out of ditches. */
  double castGround(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const
  {
    double before = 0;
    for (double at = 0; at < kFar;)
    {
      const double height = over(from + to * at);
      if (height <= 0)
      {
        return bisected(from, to, before, at);
      }
      before = at;
      at += std::clamp(0.3 * height, 0.01, 0.5);
    }
    return kFar;
  }

  double bisected(
      const Eigen::Vector3d& from, const Eigen::Vector3d& to, double above, double below) const
  {
    for (int i = 0; i < 12; ++i)
    {
      const double middle = (above + below) / 2;
      (over(from + to * middle) > 0 ? above : below) = middle;
    }
    return below;
  }

  static double castBox(const Box& box, const Eigen::Vector3d& from, const Eigen::Vector3d& to)
  {
    double enters = 0;
    double leaves = kFar;
    for (int i = 0; i < 3; ++i)
    {
      const double a = (box.min[i] - from[i]) / to[i];
      const double b = (box.max[i] - from[i]) / to[i];
      enters = std::max(enters, std::min(a, b));
      leaves = std::min(leaves, std::max(a, b));
    }
    return enters < leaves ? enters : kFar;
  }
};

/** A spinning lidar that stands upright. */
struct DrawnLidar
{
  Eigen::Vector3d p_base = {0, 0, 1.9};
  int rings = 32;
  double lowest_deg = -30;
  double highest_deg = 10;
  int columns = 900;

  /** A turn; with `T_map_base` where the vehicle stands. */
  points::ScanBuffer turn(
      const DrawnWorld& world,
      const Eigen::Isometry3d& T_map_base = Eigen::Isometry3d::Identity()) const
  {
    points::ScanBuffer scan;
    scan.T_base_sensor.translation() = p_base;
    const Eigen::Vector3d origin = T_map_base * p_base;
    for (int column = 0; column < columns; ++column)
    {
      for (int ring = 0; ring < rings; ++ring)
      {
        const Eigen::Vector3d d = beam(ring, column);
        if (const auto range = world.cast(origin, T_map_base.linear() * d))
        {
          add(p_base + d * *range, ring, scan);
        }
      }
    }
    return scan;
  }

  Eigen::Vector3d beam(int ring, int column) const
  {
    const double step_deg = rings > 1 ? (highest_deg - lowest_deg) / (rings - 1) : 0;
    const double up = (lowest_deg + ring * step_deg) * geometry::kPi / 180;
    const double around = (column + 0.37) * 2 * geometry::kPi / columns;
    return {std::cos(up) * std::cos(around), std::cos(up) * std::sin(around), std::sin(up)};
  }

  static void add(const Eigen::Vector3d& p, int ring, points::ScanBuffer& scan)
  {
    scan.x.push_back(static_cast<float>(p.x()));
    scan.y.push_back(static_cast<float>(p.y()));
    scan.z.push_back(static_cast<float>(p.z()));
    scan.ring.push_back(static_cast<uint16_t>(ring));
  }
};

/** A unit map of a single cloud, and what to ask of it. */
struct DrawnUnitMap
{
  multi_lidar_grid::Params params;
  geometry::Vehicle vehicle;
  Eigen::Isometry3d T_map_base = Eigen::Isometry3d::Identity();
  multi_lidar_grid::SensorParams sensor = multi_lidar_grid::sensorParams({}, "");
  multi_lidar_grid::UnitMap map = multi_lidar_grid::UnitMap(1);
  multi_lidar_grid::UnitMapper::Counts counts;
  double ground_m = 0;  //!< under the vehicle

  DrawnUnitMap()
  {
    params.window_m = 60;
    vehicle.footprint_xs_m = {-1, 1, 1, -1};
    vehicle.max_slope_deg = 20;
  }

  void make(const points::Scan& scan) { make(scan, poses::PoseTrack::constant(T_map_base)); }

  void make(const points::Scan& scan, const poses::PoseTrack& track)
  {
    namespace grid = multi_lidar_grid;
    grid::UnitMapper mapper(params, vehicle);
    map = grid::UnitMap(static_cast<int32_t>(std::lround(params.window_m / params.cell_size_m)));
    grid::Cloud cloud;
    cloud.scan = scan;
    cloud.stamp = scan.stamp;
    cloud.path = *grid::SensorPath::along(scan, scan.stamp, track);
    const Eigen::Vector3d p = cloud.path.pose().translation();
    counts = mapper.make(cloud, sensor, cellAt(p.x(), p.y()), map);
    ground_m = mapper.groundAt(cellAt(p.x(), p.y()));
  }

  geometry::CellIndex cellAt(double x_m, double y_m) const
  {
    const auto cell = [&](double metres)
    { return static_cast<int32_t>(std::floor(metres / params.cell_size_m)); };
    return {cell(x_m), cell(y_m)};
  }

  const multi_lidar_grid::UnitCell& at(double x_m, double y_m) const
  {
    return map.cells.at(cellAt(x_m, y_m));
  }

  layers::OccupancyState stateAt(double x_m, double y_m) const { return at(x_m, y_m).state; }

  /** The cells from one place along x: ' ' unknown, '.' free, '#' obstacle, 'v' negative, '^'
   * overhang. */
  std::string rowFrom(double x_m, double y_m, int cells) const
  {
    std::string row;
    for (int i = 0; i < cells; ++i)
    {
      const auto state = stateAt(x_m + (i + 0.5) * params.cell_size_m, y_m);
      row += std::string(" .#v^")[static_cast<size_t>(state)];
    }
    return row;
  }

  /** How many cells of a rectangle are of a state. */
  int count(layers::OccupancyState state, Eigen::Vector2d min, Eigen::Vector2d max) const
  {
    int found = 0;
    map.cells.forEachIn(
        {cellAt(min.x(), min.y()), cellAt(max.x(), max.y())},
        [&](geometry::CellIndex, const multi_lidar_grid::UnitCell& cell)
        { found += cell.state == state ? 1 : 0; });
    return found;
  }
};
}  // namespace traverse::testing
