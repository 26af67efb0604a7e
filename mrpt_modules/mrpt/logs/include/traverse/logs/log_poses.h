// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/logs/log_params.h>
#include <traverse/logs/log_report.h>
#include <traverse/observations/observation_params.h>
#include <traverse/poses/pose_source.h>

#include <filesystem>
#include <vector>

namespace traverse::logs
{
/** Stamped poses of a log, in file order. */
struct PoseReading
{
  std::vector<poses::StampedPose> poses;
  LogReport report;
};

/** Reads the vehicle's poses in a child process, like LogReader.
 *
 * odometry: CObservationOdometry as it stands, or the increments of action/sensory-frame pairs put
 * together, each stamped with the first stamp of the frame that follows it (its own, where that has
 * none); whichever of the two comes first in the log is taken. robot_pose: CObservationRobotPose,
 * less the pose of its sensor on the vehicle. icp_2d: MRPT's 2-D ICP SLAM over level
 * CObservation2DRangeScan, helped by the odometry of the log. icp_3d: registration::ScanToMap over
 * whatever becomes a scan; its refusals are counted among the rejected. ins: poses::insPoses() of
 * CObservationGPS and CObservationIMU. Throws std::invalid_argument for
 * identity and file, which take no pass over the log, and LogError as LogReader does. */
PoseReading readLogPoses(
    const std::filesystem::path& file,
    const poses::PoseParams& wanted,
    const LogParams& params,
    const observations::ObservationParams& sensors,
    const ReadOptions& options = {});

/** The same with the source's options at their defaults. */
PoseReading readLogPoses(
    const std::filesystem::path& file,
    poses::PoseSource source,
    const LogParams& params,
    const observations::ObservationParams& sensors,
    const ReadOptions& options = {});
}  // namespace traverse::logs
