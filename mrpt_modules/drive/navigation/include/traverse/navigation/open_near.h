// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/pose2.h>
#include <traverse/navigation/costmap.h>
#include <traverse/navigation/planner.h>

#include <optional>

namespace traverse::navigation
{
inline constexpr double kNearGoal_m = 4;

/** From far off a goal may look blocked that is not: the open place next to it to which the
 * vehicle can come, to look from there. Nothing where none is nearer to the goal than the vehicle,
 * or than kNearGoal_m. */
std::optional<Goal> openNear(
    const Costmap& costmap, const Goal& goal, const geometry::Pose2& vehicle);
}  // namespace traverse::navigation
