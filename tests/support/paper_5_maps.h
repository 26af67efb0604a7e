// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/evaluation/ghosts.h>
#include <traverse/evaluation/occupancy_score.h>
#include <traverse/multi_lidar_grid/multi_lidar_grid.h>

#include <nlohmann/json.hpp>
#include <string>
#include <support/paper_5_drive.h>
#include <utility>
#include <vector>

// Maps of several lidars on the drives of paper 5, and how they are judged.
namespace traverse::testing
{
/** The options of ini/scenes/paper_5.ini's car: the wing lidars see nothing behind them, where the
 * car is. */
inline multi_lidar_grid::Params paper5Params(bool as_in_the_paper)
{
  multi_lidar_grid::Params params;
  params.sensor_labels = "LEFT RIGHT";
  params.sensor_first_azimuths_deg = {-110, -110};
  params.sensor_last_azimuths_deg = {110, 110};
  if (as_in_the_paper)
  {
    params.cells = multi_lidar_grid::CellRule::paper;
    params.trace = multi_lidar_grid::TraceRule::paper;
  }
  return params;
}

/** One layer of a window, made cell by cell. */
template <class Of>
layers::LayerSet occupancyLayer(
    const geometry::Lattice& lattice, const geometry::CellRect& window, Of&& of)
{
  layers::LayerSet set;
  set.lattice = lattice;
  set.extent = window;
  set.class_layer = "occupancy_state";
  std::vector<uint8_t> states;
  states.reserve(set.size());
  for (int32_t y = window.min.y; y < window.max.y; ++y)
  {
    for (int32_t x = window.min.x; x < window.max.x; ++x)
    {
      states.push_back(static_cast<uint8_t>(of(geometry::CellIndex{x, y})));
    }
  }
  set.layers.push_back({set.class_layer, "1", std::move(states)});
  return set;
}

/** A map that takes a run's clouds, and what it was worth. */
class JudgedMap
{
 public:
  using Params = multi_lidar_grid::Params;

  JudgedMap(const Params& params, bool deskews, const Paper5Drive& drive) :
      params_(params),
      deskews_(deskews),
      vehicle_(drive.vehicle()),
      track_(drive.ins()),
      state_(params, drive.vehicle())
  {
  }

  /** `skewed` and `deskewed`: the same cloud. */
  void insert(const points::Decoded& skewed, const points::Decoded& deskewed)
  {
    const points::Scan scan = (deskews_ ? deskewed : skewed).view();
    multi_lidar_grid::update(state_, scan, track_, params_, vehicle_);
  }

  void judge(const layers::LayerSet& truth, const evaluation::OccupancyParams& circle)
  {
    const layers::LayerSet map = occupancyLayer(
        state_.lattice, truth.extent, [&](geometry::CellIndex c) { return stateOf(c); });
    evaluation::OccupancyParams params = circle;
    plain_ += evaluation::occupancyScore(map, truth, params);
    params.tolerance_cells = 0;
    strict_ += evaluation::occupancyScore(map, truth, params);
  }

  /** Which of the cells of the latest clouds of up to `sensors` lidars, roof first, are known. */
  layers::LayerSet knownNow(const geometry::CellRect& window, bool roof_only) const
  {
    return occupancyLayer(
        state_.lattice, window,
        [&](geometry::CellIndex c)
        {
          for (const multi_lidar_grid::Sensor& sensor : state_.sensors.all())
          {
            const auto* cell = sensor.latest.cells.get(c);
            const bool counts = sensor.has_cloud && (!roof_only || sensor.label == "ROOF");
            if (counts && cell != nullptr && cell->state != layers::OccupancyState::unknown)
            {
              return cell->state;
            }
          }
          return layers::OccupancyState::unknown;
        });
  }

  /** Keeps which of the departures' cells are obstacles now. */
  void watch(const std::vector<evaluation::Departure>& departures, double time_s)
  {
    evaluation::ObstacleFrame frame{time_s, {}};
    for (const evaluation::Departure& departure : departures)
    {
      const bool recent = departure.left_s <= time_s && time_s < departure.left_s + kWatched_s;
      if (recent && stateOf(departure.cell) == layers::OccupancyState::obstacle)
      {
        frame.obstacles.push_back(departure.cell);
      }
    }
    frames_.push_back(std::move(frame));
  }

  nlohmann::json result(
      const std::vector<evaluation::Departure>& people,
      const std::vector<evaluation::Departure>& cars) const
  {
    return {
        {"plain", numbersOf(plain_)},
        {"strict", numbersOf(strict_)},
        {"ghosts_people", evaluation::ghostScore(frames_, people).seconds},
        {"ghosts_cars", evaluation::ghostScore(frames_, cars).seconds},
        {"clocks", clocks()}};
  }

  static std::vector<uint64_t> numbersOf(const evaluation::OccupancyScore& s)
  {
    return {s.obstacles,     s.found_obstacles, s.known_free,     s.false_obstacles,
            s.false_ditches, s.free_in_both,    s.free_in_either, s.ditches,
            s.found_ditches, s.ditches_as_free, s.free_cells,     s.unknown_free};
  }

  static evaluation::OccupancyScore scoreOf(const nlohmann::json& numbers)
  {
    const auto n = numbers.get<std::vector<uint64_t>>();
    return {n.at(0), n.at(1), n.at(2), n.at(3), n.at(4),  n.at(5),
            n.at(6), n.at(7), n.at(8), n.at(9), n.at(10), n.at(11)};
  }

  const geometry::Lattice& lattice() const { return state_.lattice; }

 private:
  static constexpr double kWatched_s = 10;  // ghosts that stay longer are counted with that

  layers::OccupancyState stateOf(geometry::CellIndex c) const
  {
    const multi_lidar_grid::Cell* cell = state_.cells.get(c);
    return cell == nullptr ? layers::OccupancyState::unknown : cell->state;
  }

  /** What the map adds to each lidar's stamps, s. */
  nlohmann::json clocks() const
  {
    nlohmann::json by_label = nlohmann::json::object();
    for (const multi_lidar_grid::Sensor& sensor : state_.sensors.all())
    {
      by_label[sensor.label] = sensor.clock_offset_s;
    }
    return by_label;
  }

  Params params_;
  bool deskews_;
  geometry::Vehicle vehicle_;
  const poses::PoseTrack& track_;
  multi_lidar_grid::State state_;
  evaluation::OccupancyScore plain_;
  evaluation::OccupancyScore strict_;
  std::vector<evaluation::ObstacleFrame> frames_;
};
}  // namespace traverse::testing
