// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/pose2.h>

#include <Eigen/Geometry>

namespace traverse::poses
{
/** On the plane z = 0. The same bits on every processor. */
Eigen::Isometry3d levelPose(const geometry::Pose2& pose);

/** Place and heading of the x axis, which must not be upright. The same bits on every processor. */
geometry::Pose2 seenFromAbove(const Eigen::Isometry3d& T);
}  // namespace traverse::poses
