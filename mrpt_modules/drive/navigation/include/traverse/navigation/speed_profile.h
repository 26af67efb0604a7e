// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/drivetrain.h>
#include <traverse/navigation/costmap.h>
#include <traverse/navigation/path.h>
#include <traverse/options/option.h>

#include <concepts>
#include <cstdint>
#include <string_view>
#include <type_traits>
#include <vector>

namespace traverse::navigation
{
/** Section [Speed]. */
struct SpeedParams
{
  double lateral_accel_mps2 = 1.0;
  double friction = 0.6;
  double friction_margin = 0.5;
  double reaction_s = 0.3;
  double creep_mps = 0.15;

  friend bool operator==(const SpeedParams&, const SpeedParams&) = default;
};

template <class P, class F>
requires std::same_as<std::remove_const_t<P>, SpeedParams>

void visit(P& p, F&& f)
{
  using options::Option;
  f(Option{"lateral_accel_mps2", "most in curves, m/s2", {0.05, 20}}, p.lateral_accel_mps2);
  f(Option{"friction", "coefficient of friction where no map knows it, 1", {0.01, 2}}, p.friction);
  f(
      Option{
          "friction_margin",
          "share of the friction that braking and curves may use together, 1",
          {0.05, 1}},
      p.friction_margin);
  f(Option{"reaction_s", "from a map's scan to the brakes, s", {0, 10}}, p.reaction_s);
  f(Option{"creep_mps", "no limit but that of standing still lies below, m/s", {0.01, 5}},
    p.creep_mps);
}

/** What holds the speed down at a place. */
enum class SpeedReason : uint8_t
{
  vehicle,    //!< its highest speed, or its acceleration
  curve,      //!< lateral acceleration, friction, how fast it turns or a car steers
  ground,     //!< roughness class, by Costmap::speed_mps under the vehicle's middle
  unknown,    //!< it must be able to stop before what no map has seen
  end,        //!< it must stop at the path's end, or where it turns round
  clearance,  //!< a hard buffer is nearer than it gets within reaction_s
  grip,       //!< a curve on ground of less friction than SpeedParams::friction
};

/** For people and reports: "vehicle" ... */
std::string_view nameOf(SpeedReason reason);

/** Highest speed at a place of the path, m/s (backward too), and why. */
struct SpeedLimit
{
  double speed_mps = 0;
  SpeedReason reason = SpeedReason::vehicle;
};

/** One for each point of the path, from `speed_mps` at its beginning on: limits at each point by
 * itself, then passes backward and forward so that no acceleration is above the drivetrain's, nor,
 * together with that of the curve, above friction_margin * friction * g, by Costmap::friction under
 * the vehicle's middle where it is known. Stops (0) at the end and where the path changes between
 * forward and backward; elsewhere it is creep_mps at least, or the vehicle's highest speed where
 * that is less.
 *
 * Within v reaction_s + v^2 / (2 deceleration) of the first unknown cell on its way it stands. A
 * cell that is unknown amid four known ones is a gap between beams and does not count. */
std::vector<SpeedLimit> speedProfile(
    const Path& path,
    const Costmap& costmap,
    const geometry::Drivetrain& drivetrain,
    double speed_mps,
    const SpeedParams& params);
}  // namespace traverse::navigation
