// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/navigation/speed_profile.h>

#include <vector>

namespace traverse::navigation
{
/** What accelerations are left to use, m/s2. */
struct Grip
{
  double brake_mps2;    //!< straight on
  double lateral_mps2;  //!< most in curves
  double sum_mps2;      //!< braking or accelerating, and curve, together
};

Grip gripOf(const geometry::Drivetrain& drivetrain, const SpeedParams& params);

/** What limits each point by itself, without regard to those around it; 0 at stops. */
std::vector<SpeedLimit> limitsByPlace(
    const Path& path,
    const Costmap& costmap,
    const geometry::Drivetrain& drivetrain,
    const SpeedParams& params);
}  // namespace traverse::navigation
