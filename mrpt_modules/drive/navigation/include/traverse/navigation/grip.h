// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/drivetrain.h>
#include <traverse/geometry/vehicle.h>
#include <traverse/navigation/costmap.h>
#include <traverse/navigation/speed_profile.h>

namespace traverse::navigation
{
inline constexpr double kGravity = 9.81;  //!< m/s2

/** What accelerations ground of some friction leaves, m/s2. */
struct Grip
{
  double brake_mps2 = 0;    //!< straight on
  double lateral_mps2 = 0;  //!< most in curves
  double sum_mps2 = 0;      //!< braking or accelerating, and curve, together
};

/** By what the vehicle can do and SpeedParams::friction_margin times friction * g. NaN, where no
 * map knows the friction: SpeedParams::friction. */
Grip gripOn(double friction, const geometry::Drivetrain& drivetrain, const SpeedParams& params);

/** The worse of two in everything. */
Grip weaker(const Grip& a, const Grip& b);

/** Least friction of the cell under the pose and of those whose middle is under the footprint; NaN
 * where no map knows it. */
double frictionUnder(
    const Costmap& costmap, const geometry::Vehicle& vehicle, const geometry::Pose2& pose);
}  // namespace traverse::navigation
