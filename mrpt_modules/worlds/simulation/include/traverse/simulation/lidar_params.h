// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/options/option.h>
#include <traverse/sensors/velodyne.h>

#include <array>
#include <string>
#include <string_view>
#include <utility>

namespace traverse::simulation
{
/** Section [Lidar_NN]: a lidar, where it sits, and what is wrong with it. */
struct LidarParams
{
  std::string label = "LIDAR";
  sensors::VelodyneModel model = sensors::VelodyneModel::hdl32e;
  sensors::ReturnMode mode = sensors::ReturnMode::strongest;
  double rate_hz = 10;
  double phase_deg = 0;
  double start_s = 0;
  double x_m = 0;
  double y_m = 0;
  double z_m = 1.8;
  double yaw_deg = 0;
  double pitch_deg = 0;
  double roll_deg = 0;
  double range_noise_m = 0.008;
  double laser_bias_m = 0.006;
  double azimuth_jitter_deg = 0.0;
  double max_range_m = 0;
  double half_range_m = -1;
  double drop_out = 0;
  double rain_share = 0;
  double turn_loss = 0;
  double clock_offset_s = 0;
  double late_s = 0;
  double dead_after_s = 0;
  int repeat_every = 0;
  int backward_every = 0;

  friend bool operator==(const LidarParams&, const LidarParams&) = default;
};

template <class P, class F>
void visitLidarPlace(P& p, F&& f)
{
  using options::Option;
  f(Option{"label", "name of the sensor in the log"}, p.label);
  f(Option{"model", "the sensor"}, p.model);
  f(Option{"mode", "which return of a beam it reports (they differ in rain only)"}, p.mode);
  f(Option{"rate_hz", "turns a second", {1, 20}}, p.rate_hz);
  f(Option{"phase_deg", "encoder azimuth at which a turn begins, clockwise, deg", {0, 359.99}},
    p.phase_deg);
  f(Option{"start_s", "the first turn begins so long after the recording does, s", {0, 3600}},
    p.start_s);
  f(Option{"x_m", "where it sits in the vehicle frame, m", {-50, 50}}, p.x_m);
  f(Option{"y_m", "likewise, m", {-50, 50}}, p.y_m);
  f(Option{"z_m", "likewise, m", {-50, 50}}, p.z_m);
  f(
      Option{
          "yaw_deg", "how it is turned: about z, then its own y, then its own x, deg", {-360, 360}},
      p.yaw_deg);
  f(Option{"pitch_deg", "likewise, deg", {-180, 180}}, p.pitch_deg);
  f(Option{"roll_deg", "likewise, deg", {-180, 180}}, p.roll_deg);
}

template <class P, class F>
void visitLidarMeasuring(P& p, F&& f)
{
  using options::Option;
  f(Option{"range_noise_m", "standard deviation from one range to the next, m", {0, 1}},
    p.range_noise_m);
  f(
      Option{
          "laser_bias_m",
          "standard deviation of what each laser measures too much, always the same, m",
          {0, 1}},
      p.laser_bias_m);
  f(
      Option{
          "azimuth_jitter_deg",
          "standard deviation of where a firing looks, from what its packet says, deg",
          {0, 5}},
      p.azimuth_jitter_deg);
  f(Option{"max_range_m", "longest range, m; 0: the data sheet's", {0, 240}}, p.max_range_m);
  f(
      Option{
          "half_range_m",
          "at this range half of the beams come back from a white surface met at a right angle; "
          "less from dark and slanting ones, m; -1: 600 for a VLP-32C, 370 for the others; 0: all "
          "come back from everywhere",
          {-1, 10000}},
      p.half_range_m);
}

template <class P, class F>
void visitLidarFaults(P& p, F&& f)
{
  using options::Option;
  f(Option{"drop_out", "share of the returns that are lost, 0..1", {0, 1}}, p.drop_out);
  f(Option{"rain_share", "share of the beams that meet a drop near the sensor, 0..1", {0, 1}},
    p.rain_share);
  f(Option{"turn_loss", "share of the turns that never arrive, 0..1", {0, 1}}, p.turn_loss);
  f(Option{"clock_offset_s", "its clock is ahead by so much, s", {-3600, 3600}}, p.clock_offset_s);
  f(Option{"late_s", "its turns arrive so late, s", {0, 3600}}, p.late_s);
  f(Option{"dead_after_s", "it is silent from then on, s of the recording; 0: never", {0, 3600}},
    p.dead_after_s);
  f(Option{"repeat_every", "every such turn arrives twice; 0: none", {0, 1000000}}, p.repeat_every);
  f(
      Option{
          "backward_every",
          "every such turn is stamped a turn and a half too early; 0: none",
          {0, 1000000}},
      p.backward_every);
}

template <class F>
void visit(LidarParams& p, F&& f)
{
  visitLidarPlace(p, f);
  visitLidarMeasuring(p, f);
  visitLidarFaults(p, f);
}

template <class F>
void visit(const LidarParams& p, F&& f)
{
  visitLidarPlace(p, f);
  visitLidarMeasuring(p, f);
  visitLidarFaults(p, f);
}
}  // namespace traverse::simulation

template <>
struct traverse::options::EnumNames<traverse::sensors::VelodyneModel>
{
  using E = traverse::sensors::VelodyneModel;
  static constexpr std::array<std::pair<E, std::string_view>, 3> kNames = {
      {{E::hdl32e, "HDL-32E"}, {E::vlp16, "VLP-16"}, {E::vlp32c, "VLP-32C"}}};
};

template <>
struct traverse::options::EnumNames<traverse::sensors::ReturnMode>
{
  using E = traverse::sensors::ReturnMode;
  static constexpr std::array<std::pair<E, std::string_view>, 2> kNames = {
      {{E::strongest, "strongest"}, {E::last, "last"}}};
};
