// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/obs/CObservationVelodyneScan.h>

#include <cmath>
#include <string>
#include <support/data.h>
#include <support/synthetic_logs.h>
#include <vector>

namespace traverse::testing
{
/** The one turn of a VLP-16 that Debian ships. */
inline mrpt::obs::CObservationVelodyneScan debianVelodyneScan()
{
  mrpt::io::CFileGZInputStream file(mrptData("test_velodyne_VLP16.rawlog"));
  auto archive = mrpt::serialization::archiveFrom(file);
  return dynamic_cast<const mrpt::obs::CObservationVelodyneScan&>(*archive.ReadObject());
}

/** Where a car is that drives a bend over rough ground, so that points need their own poses. */
inline mrpt::obs::CObservationRobotPose bendPose(double t_s)
{
  mrpt::obs::CObservationRobotPose pose;
  pose.sensorLabel = "POSE";
  pose.timestamp = observations::toTimePoint(kLogStart + static_cast<poses::TimeNs>(t_s * 1e9));
  pose.pose.mean = mrpt::poses::CPose3D(
      6 * t_s, std::sin(t_s), 0.1 * std::sin(3 * t_s), 0.7 * t_s, 0.03 * std::sin(5 * t_s),
      0.02 * std::cos(4 * t_s));
  return pose;
}

/** A log of that turn at these times, in this order, of a car in a bend: the packets are the same,
 * and each point is deskewed with the pose at its own time. A pose every 0.1 s between the scans.
 */
inline std::string drivenVelodyneLog(const std::vector<double>& scan_times_s)
{
  mrpt::obs::CObservationVelodyneScan scan = debianVelodyneScan();
  std::string log = serialised(bendPose(-0.2)) + serialised(bendPose(-0.1));
  int poses = 0;
  for (const double t_s : scan_times_s)
  {
    for (; poses / 10.0 < t_s + 0.3; ++poses)
    {
      log += serialised(bendPose(poses / 10.0));
    }
    scan.timestamp = observations::toTimePoint(kLogStart + static_cast<poses::TimeNs>(t_s * 1e9));
    scan.originalReceivedTimestamp = scan.timestamp;
    log += serialised(scan);
  }
  return log;
}
}  // namespace traverse::testing
