// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/geometry/exact_trig.h>
#include <traverse/poses/level_pose.h>
#include <traverse/poses/pose_track.h>

namespace traverse::poses
{
Eigen::Isometry3d levelPose(const geometry::Pose2& pose)
{
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() = Eigen::Vector3d(pose.x_m, pose.y_m, 0);
  T.linear() = rotationBy(pose.yaw_rad, Eigen::Vector3d::UnitZ());
  return T;
}

geometry::Pose2 seenFromAbove(const Eigen::Isometry3d& T)
{
  return {
      T.translation().x(), T.translation().y(),
      geometry::angleOf(T.linear()(1, 0), T.linear()(0, 0))};
}
}  // namespace traverse::poses
