// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/poses/pose_track.h>

#include <mrpt/core/Clock.h>
#include <mrpt/poses/CPose2D.h>
#include <mrpt/poses/CPose3D.h>

#include <Eigen/Geometry>

#include <optional>

namespace traverse::observations
{
/** The same rigid motion; entries of the rotation rounded to 2^-40, so that the last bits of a C
 * library's sin and cos do not reach the maps. NaN stays NaN. */
Eigen::Isometry3d toIsometry(const mrpt::poses::CPose3D& pose);

/** A pose in the plane, with the same bits on every processor; NaN stays NaN. */
Eigen::Isometry3d toIsometry(const mrpt::poses::CPose2D& pose);
mrpt::poses::CPose3D toPose3D(const Eigen::Isometry3d& motion);

/** Nothing for INVALID_TIMESTAMP and for times before 1980 or after 2100: those are no clock's. */
std::optional<poses::TimeNs> toTime(const mrpt::Clock::time_point& time);
mrpt::Clock::time_point toTimePoint(poses::TimeNs time);  //!< to 100 ns
}  // namespace traverse::observations
