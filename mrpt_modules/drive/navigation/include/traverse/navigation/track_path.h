// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/drivetrain.h>
#include <traverse/navigation/path.h>

#include <optional>
#include <span>

namespace traverse::navigation
{
/** What keeps a car-like vehicle on a piece of a path that goes one way (forward or backward), at a
 * speed (its amount): the path's own curvature a little ahead, so that the wheels are turned in
 * time, and what leads it back, critically damped over the way that it drives (C. Samson: "Control
 * of chained systems: application to path following and time-varying point-stabilization of mobile
 * robots", IEEE TAC 1995, linear law). No tighter than the vehicle turns.
 *
 * Nothing where the piece has less than two points, or the vehicle is further than 0.6 m or 60
 * degrees off it: then its curves lead nowhere. */
std::optional<geometry::Twist2> trackPath(
    std::span<const PathPoint> piece,
    const geometry::Pose2& pose,
    double speed_mps,
    const geometry::Drivetrain& drivetrain);
}  // namespace traverse::navigation
