// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/multi_lidar_grid/multi_lidar_grid.h>

#include <string>
#include <vector>

// Maps of several lidars drawn as text, seen from above: one character a cell, the top row has the
// largest y, the lower left cell is (0, 0).
//
//     (blank)  unknown   .  free   #  obstacle   v  negative   n  overhang
namespace traverse::testing
{
using Drawing = std::vector<std::string>;

constexpr std::string_view kDrawnStates = " .#vn";

inline layers::OccupancyState drawnState(char c)
{
  const size_t code = kDrawnStates.find(c);
  return static_cast<layers::OccupancyState>(code == std::string_view::npos ? 0 : code);
}

/** Calls f(CellIndex, OccupancyState) for each drawn cell that is known. */
template <class F>
void forEachDrawn(const Drawing& drawing, F&& f)
{
  for (size_t row = 0; row < drawing.size(); ++row)
  {
    const std::string& line = drawing[drawing.size() - 1 - row];
    for (size_t column = 0; column < line.size(); ++column)
    {
      const layers::OccupancyState state = drawnState(line[column]);
      if (state != layers::OccupancyState::unknown)
      {
        f(geometry::CellIndex{static_cast<int32_t>(column), static_cast<int32_t>(row)}, state);
      }
    }
  }
}

/** Codes of a window as text, by the characters given. */
inline Drawing drawn(
    const layers::LayerSet& set, std::string_view layer, std::string_view characters)
{
  const auto& codes = std::get<std::vector<uint8_t>>(set.find(layer)->data);
  Drawing lines;
  const auto width = static_cast<size_t>(set.extent.width());
  for (size_t row = static_cast<size_t>(set.extent.height()); row-- > 0;)
  {
    std::string line;
    for (size_t column = 0; column < width; ++column)
    {
      line += characters.at(codes[row * width + column]);
    }
    lines.push_back(line);
  }
  return lines;
}

/** A small map: 20 cells of 0.5 m, with a robot at its middle. */
inline multi_lidar_grid::Map smallMap()
{
  multi_lidar_grid::Params params;
  params.cell_size_m = 0.5;
  params.window_m = 10;
  const geometry::Vehicle vehicle;
  multi_lidar_grid::Map map{params, vehicle, multi_lidar_grid::State(params, vehicle)};
  map.state.cells.moveTo({5, 5});
  map.state.now = 10'000'000'000;
  map.state.robot = poses::StampedPose{map.state.now, Eigen::Isometry3d::Identity()};
  return map;
}

/** Gives the map a sensor whose latest cloud, of `age_s` before now, says what is drawn. */
inline void addCloud(
    multi_lidar_grid::Map& map, std::string_view label, const Drawing& drawing, double age_s = 0)
{
  using namespace multi_lidar_grid;
  Sensor& sensor = map.state.sensors.obtain(label, map.state.cells.region().width());
  sensor.has_cloud = true;
  sensor.clouds = 1;
  sensor.newest = map.state.now - static_cast<poses::TimeNs>(age_s * 1e9);
  sensor.latest.stamp = sensor.newest;
  sensor.latest.cells.moveTo({5, 5});
  sensor.latest.touched = sensor.latest.cells.region();
  forEachDrawn(
      drawing, [&](geometry::CellIndex c, layers::OccupancyState state)
      { sensor.latest.cells.at(c).state = state; });
}

/** Puts a drawing into the accumulated map, as seen by the sensors of these bits. */
inline void accumulate(multi_lidar_grid::Map& map, const Drawing& drawing, uint32_t seen_by)
{
  forEachDrawn(
      drawing,
      [&](geometry::CellIndex c, layers::OccupancyState state)
      {
        multi_lidar_grid::Cell& cell = map.state.cells.at(c);
        cell.state = state;
        cell.seen_by |= seen_by;
        cell.up_to = state == layers::OccupancyState::free ? 5 : 0;
        cell.last_seen = map.state.now - 2'000'000'000;
        cell.last_hit = state == layers::OccupancyState::free ? 0 : cell.last_seen;
      });
}

inline layers::LayerSet layersOf(
    const multi_lidar_grid::Map& map, std::optional<geometry::CellRect> window = std::nullopt)
{
  return multi_lidar_grid::layerSet(map.state, map.params, map.vehicle, window);
}
}  // namespace traverse::testing
