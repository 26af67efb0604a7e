// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/navigation/costmap.h>

#include <Eigen/Core>

#include <vector>

namespace traverse::navigation
{
/** Obstacle cells within range_m of the vehicle, as points of the vehicle frame seen from above (x,
 * y in the middle of the cell, z = how high it stands over the ground, m; unknown heights and
 * ground that falls away: kObstacleHeight_m). Cells all of whose four neighbours are obstacles are
 * left out: nothing touches them first. */
std::vector<Eigen::Vector3f> obstaclePoints(
    const Costmap& costmap, const geometry::Pose2& pose, double range_m);

inline constexpr float kObstacleHeight_m = 0.3F;
}  // namespace traverse::navigation
