// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/nav_app/run_params.h>
#include <traverse/points/scan.h>
#include <traverse/poses/pose_track.h>
#include <traverse/registration/odometry_to_map.h>
#include <traverse/simulation/pose_sensors.h>
#include <traverse/simulation/vehicle_model.h>

#include <cstdint>
#include <vector>

namespace traverse::app
{
/** Where the pilot believes that the vehicle is: as the simulator knows (NavPoses::exact), or by
 * odometry with drift and noise that scans matched to a map put right (NavPoses::icp_3d). Both know
 * the place and heading at the start. */
class PoseFeed
{
 public:
  PoseFeed(
      NavPoses source,
      const simulation::OdometryParams& odometry,
      const poses::StampedPose& start,
      uint64_t seed);

  /** The vehicle has moved on to a time. */
  void move(const poses::StampedPose& truth, const geometry::Twist2& wheels);

  /** A scan as decoded, before deskewing. */
  void see(const points::ScanBuffer& scan);

  /** Poses of the last second in the map frame. */
  poses::PoseTrack track() const;

  geometry::Pose2 pose() const;

  /** Of the last pose that is measured: exact, or that of a scan which was matched or which
   * odometry carried to (registration::OdometryToMap::reliedOn()). */
  poses::TimeNs measured() const { return measured_; }

 private:
  void dropOld();

  NavPoses source_;
  simulation::DeadReckoning odometry_;
  geometry::Pose2 rolled_;                 // as the wheels went, without odometry's errors
  std::vector<poses::StampedPose> moved_;  // T_odom_base (exact: T_map_base), the last second's
  registration::OdometryToMap matcher_;    // exact: T_map_odom is the identity
  poses::TimeNs measured_ = 0;
};
}  // namespace traverse::app
