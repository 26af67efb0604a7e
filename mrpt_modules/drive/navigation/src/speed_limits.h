// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/navigation/grip.h>
#include <traverse/navigation/speed_profile.h>

#include <vector>

namespace traverse::navigation
{
/** At each point of the path, by the friction under the vehicle's middle. */
std::vector<Grip> gripsAlong(
    const Path& path,
    const Costmap& costmap,
    const geometry::Drivetrain& drivetrain,
    const SpeedParams& params);

/** What limits each point by itself, without regard to those around it; 0 at stops. */
std::vector<SpeedLimit> limitsByPlace(
    const Path& path,
    const std::vector<Grip>& grips,
    const Costmap& costmap,
    const geometry::Drivetrain& drivetrain,
    const SpeedParams& params);
}  // namespace traverse::navigation
