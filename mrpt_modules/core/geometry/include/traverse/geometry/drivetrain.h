// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/options/option.h>

#include <array>
#include <concepts>
#include <cstdint>
#include <string_view>
#include <type_traits>
#include <utility>

namespace traverse::geometry
{
/** How a vehicle turns. */
enum class Steering : uint8_t
{
  differential,  //!< two driven wheels; turns on the spot
  ackermann,  //!< steered front wheels; the vehicle frame's origin is the middle of the rear axle
};

/** What a vehicle can do: section [Drivetrain]. */
struct Drivetrain
{
  Steering steering = Steering::differential;
  double wheelbase_m = 0.6;
  double max_steer_deg = 30;
  double max_steer_rate_degps = 60;
  double max_speed_mps = 1.0;
  double max_reverse_mps = 0.5;
  double max_accel_mps2 = 1.0;
  double max_decel_mps2 = 2.0;
  double max_yaw_rate_degps = 60;
  double max_yaw_accel_degps2 = 180;
  double mass_kg = 60;

  friend bool operator==(const Drivetrain&, const Drivetrain&) = default;
};

template <class P, class F>
requires std::same_as<std::remove_const_t<P>, Drivetrain>

void visit(P& p, F&& f)
{
  using options::Option;
  f(Option{"steering", "differential: turns on the spot; ackermann: steers its front wheels"},
    p.steering);
  f(Option{"wheelbase_m", "ackermann: from the rear axle to the front axle, m", {0.05, 20}},
    p.wheelbase_m);
  f(Option{"max_steer_deg", "ackermann: largest steering angle, deg", {1, 80}}, p.max_steer_deg);
  f(Option{"max_steer_rate_degps", "ackermann: how fast it steers, deg/s", {1, 1000}},
    p.max_steer_rate_degps);
  f(Option{"max_speed_mps", "forward, m/s", {0.05, 60}}, p.max_speed_mps);
  f(Option{"max_reverse_mps", "backward, m/s; 0: it does not drive backward", {0, 60}},
    p.max_reverse_mps);
  f(Option{"max_accel_mps2", "m/s2", {0.05, 20}}, p.max_accel_mps2);
  f(Option{"max_decel_mps2", "when it brakes, m/s2", {0.05, 20}}, p.max_decel_mps2);
  f(Option{"max_yaw_rate_degps", "differential: how fast it turns, deg/s", {1, 720}},
    p.max_yaw_rate_degps);
  f(Option{"max_yaw_accel_degps2", "differential: how fast that changes, deg/s2", {1, 7200}},
    p.max_yaw_accel_degps2);
  f(Option{"mass_kg", "of the vehicle, kg", {0.1, 1e5}}, p.mass_kg);
}

/** Smallest radius of the origin's way, m; 0 for vehicles that turn on the spot. */
double minTurningRadius_m(const Drivetrain& drivetrain);
}  // namespace traverse::geometry

template <>
struct traverse::options::EnumNames<traverse::geometry::Steering>
{
  using E = traverse::geometry::Steering;
  static constexpr std::array<std::pair<E, std::string_view>, 2> kNames = {
      {{E::differential, "differential"}, {E::ackermann, "ackermann"}}};
};
