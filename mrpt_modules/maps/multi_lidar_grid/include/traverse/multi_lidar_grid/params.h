// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/vehicle.h>
#include <traverse/layers/safety_buffer.h>
#include <traverse/options/option.h>

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace traverse::multi_lidar_grid
{
/** How the returns in a cell become its state. */
enum class CellRule : uint8_t
{
  standard,  //!< "default": by their height above the ground
  paper,     //!< by their spread and gaps alone
};

/** Which cells a beam frees. */
enum class TraceRule : uint8_t
{
  standard,  //!< "default": those that it passes lower than the obstacle height
  paper,     //!< all before the first obstacle, seen from above
};

/** How evidence adds up over sweeps. */
enum class Accumulation : uint8_t
{
  sweeps,    //!< a hit is an obstacle at once; so many contradicting sweeps free it
  log_odds,  //!< each hit and each pass shifts the odds
};

/** Section insertOpts of the map: doc/maps/multi_lidar_grid.md. */
struct Params
{
  double cell_size_m = 0.2;
  double window_m = 100;
  CellRule cells = CellRule::standard;
  TraceRule trace = TraceRule::standard;
  double obstacle_height_m = 0.25;
  double negative_depth_m = 0.25;
  double negative_range_m = 0;
  double max_range_m = 80;
  std::string clearing_labels;
  double clearing_range_m = 20;

  std::string sensor_labels;
  std::vector<double> sensor_ranges_m;
  std::vector<double> sensor_first_azimuths_deg;
  std::vector<double> sensor_last_azimuths_deg;
  std::vector<double> sensor_timeouts_s;
  std::vector<double> sensor_clock_offsets_s;
  double timeout_s = 0.5;
  double order_window_s = 1.0;
  bool estimate_clock_offsets = true;

  Accumulation accumulation = Accumulation::sweeps;
  int clear_after_sweeps = 3;
  double log_odds_hit = 0.9;
  double log_odds_pass = -0.4;
  double log_odds_most = 3.5;
  double forget_after_s = 0;

  double hard_buffer_m = 0;
  double soft_buffer_m = 1.2;
  layers::StripRule strip = layers::StripRule::standard;

  friend bool operator==(const Params&, const Params&) = default;
};

template <class P, class F>
void visitCells(P& p, F&& f)
{
  using options::Option;
  f(Option{"cell_size_m", "edge of a cell, m, to 1 mm", {0.02, 10}}, p.cell_size_m);
  f(
      Option{
          "window_m",
          "edge of the square around the robot that the map keeps, m (4096 cells at most)",
          {1, 2000}},
      p.window_m);
  f(
      Option{
          "cells",
          "a cell is an obstacle by its returns' heights above the ground, or by their spread "
          "alone (paper 5)"},
      p.cells);
  f(
      Option{
          "trace",
          "a beam frees the cells that it passes below obstacle_height_m, or all before the first "
          "obstacle seen from above (paper 5)"},
      p.trace);
  f(
      Option{
          "obstacle_height_m",
          "what stands higher over the ground is an obstacle, m (the paper's T_p)",
          {0.02, 5}},
      p.obstacle_height_m);
  f(
      Option{
          "negative_depth_m",
          "where the ground falls away by more, it is a negative obstacle, m; 0: none are sought",
          {0, 10}},
      p.negative_depth_m);
  f(
      Option{
          "negative_range_m",
          "negative obstacles are sought no further from the sensor, where rings lie metres apart, "
          "m; 0: as far as it sees",
          {0, 1000}},
      p.negative_range_m);
  f(Option{"max_range_m", "returns further from their sensor are left out, m", {0.5, 1000}},
    p.max_range_m);
  f(
      Option{
          "clearing_labels",
          "labels of sensors, blanks between, whose beams without return free the cells they "
          "passed: scanners that report every surface within clearing_range_m"},
      p.clearing_labels);
  f(
      Option{
          "clearing_range_m",
          "beams without return free cells up to here, m from the sensor",
          {0.1, 1000}},
      p.clearing_range_m);
}

template <class P, class F>
void visitSensors(P& p, F&& f)
{
  using options::Option;
  f(
      Option{
          "sensor_labels",
          "labels of sensors, blanks between, that the following lists speak of; others have the "
          "defaults"},
      p.sensor_labels);
  f(Option{"sensor_ranges_m", "max_range_m of each of them; empty: the same", {0.5, 1000}},
    p.sensor_ranges_m);
  f(
      Option{
          "sensor_first_azimuths_deg",
          "field of view of each of them in its own frame, counter-clockwise from here, deg; "
          "empty: a full turn",
          {-360, 360}},
      p.sensor_first_azimuths_deg);
  f(Option{"sensor_last_azimuths_deg", "... to here, deg", {-360, 360}},
    p.sensor_last_azimuths_deg);
  f(Option{"sensor_timeouts_s", "timeout_s of each of them; empty: the same", {0.01, 3600}},
    p.sensor_timeouts_s);
  f(
      Option{
          "sensor_clock_offsets_s",
          "add this to each one's stamps to have the poses' time, s; empty: estimated or 0",
          {-10, 10}},
      p.sensor_clock_offsets_s);
  f(
      Option{
          "timeout_s",
          "a sensor that was silent for longer leaves the map of the latest clouds, s",
          {0.01, 3600}},
      p.timeout_s);
  f(
      Option{
          "order_window_s",
          "clouds that come so late, by their stamps, are still taken, s",
          {0, 3600}},
      p.order_window_s);
  f(
      Option{
          "estimate_clock_offsets",
          "finds the constant offset of each sensor's clock against the poses, while driving"},
      p.estimate_clock_offsets);
}

template <class P, class F>
void visitAccumulation(P& p, F&& f)
{
  using options::Option;
  f(Option{"accumulation", "how sweeps add up: an obstacle at once and free after some, or odds"},
    p.accumulation);
  f(
      Option{
          "clear_after_sweeps",
          "accumulation = sweeps: so many in a row without a hit free an obstacle cell",
          {1, 100}},
      p.clear_after_sweeps);
  f(Option{"log_odds_hit", "accumulation = log_odds: added by a hit", {0.01, 10}}, p.log_odds_hit);
  f(Option{"log_odds_pass", "accumulation = log_odds: added by a pass", {-10, -0.01}},
    p.log_odds_pass);
  f(
      Option{
          "log_odds_most", "accumulation = log_odds: the odds go no further either way", {0.1, 50}},
      p.log_odds_most);
  f(
      Option{
          "forget_after_s",
          "a cell that nothing said anything of for longer is unknown again, s; 0: never",
          {0, 1e6}},
      p.forget_after_s);
}

template <class P, class F>
void visitBuffer(P& p, F&& f)
{
  using options::Option;
  f(
      Option{
          "hard_buffer_m",
          "nearer to an obstacle the vehicle would touch it, m; 0: half of its largest dimension",
          {0, 50}},
      p.hard_buffer_m);
  f(Option{"soft_buffer_m", "width of the soft buffer around the hard one, m", {0, 50}},
    p.soft_buffer_m);
  f(
      Option{
          "strip",
          "cuts the line as far from one obstacle as from another out of soft buffers that meet"},
      p.strip);
}

template <class F>
void visit(Params& p, F&& f)
{
  visitCells(p, f);
  visitSensors(p, f);
  visitAccumulation(p, f);
  visitBuffer(p, f);
}

template <class F>
void visit(const Params& p, F&& f)
{
  visitCells(p, f);
  visitSensors(p, f);
  visitAccumulation(p, f);
  visitBuffer(p, f);
}

std::vector<std::string_view> labelsIn(std::string_view list);  //!< blanks between; views into it

/** Throws OptionError where a member is out of its range or members contradict each other: lists of
 * other lengths, a label there twice, too many cells, a vehicle no higher than obstacle_height_m.
 */
void check(const Params& params, const geometry::Vehicle& vehicle);

/** What the options say of one sensor. */
struct SensorParams
{
  double range_m = 0;
  double first_azimuth_deg = 0;
  double last_azimuth_deg = 360;  //!< at least 360 further: a full turn
  double timeout_s = 0;
  double clock_offset_s = 0;
  bool is_offset_given = false;
  bool clears_without_return = false;
};

SensorParams sensorParams(const Params& params, std::string_view label);

/** Half of the vehicle's largest dimension seen from above, or what hard_buffer_m says, m. */
double hardBuffer_m(const Params& params, const geometry::Vehicle& vehicle);
}  // namespace traverse::multi_lidar_grid

template <>
struct traverse::options::EnumNames<traverse::multi_lidar_grid::CellRule>
{
  using E = traverse::multi_lidar_grid::CellRule;
  static constexpr std::array<std::pair<E, std::string_view>, 2> kNames = {
      {{E::standard, "default"}, {E::paper, "paper"}}};
};

template <>
struct traverse::options::EnumNames<traverse::multi_lidar_grid::TraceRule>
{
  using E = traverse::multi_lidar_grid::TraceRule;
  static constexpr std::array<std::pair<E, std::string_view>, 2> kNames = {
      {{E::standard, "default"}, {E::paper, "paper"}}};
};

template <>
struct traverse::options::EnumNames<traverse::multi_lidar_grid::Accumulation>
{
  using E = traverse::multi_lidar_grid::Accumulation;
  static constexpr std::array<std::pair<E, std::string_view>, 2> kNames = {
      {{E::sweeps, "sweeps"}, {E::log_odds, "log_odds"}}};
};
