// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "odometry_track.h"

#include <traverse/observations/convert.h>

#include <mrpt/obs/CObservationOdometry.h>

#include <utility>

namespace traverse::logs
{
bool OdometryTrack::add(const mrpt::obs::CObservation& observation)
{
  const auto stamp = observations::toTime(observation.timestamp);
  if (!frame_stamp_)
  {
    frame_stamp_ = stamp;
  }
  const auto* odometry = dynamic_cast<const mrpt::obs::CObservationOdometry*>(&observation);
  if (odometry == nullptr || form_ == Form::actions)
  {
    return false;
  }
  form_ = Form::observations;
  pose_ = observations::toIsometry(odometry->odometry);
  ready_ = poses::StampedPose{stamp.value_or(0), pose_};
  return true;
}

void OdometryTrack::add(const Movement& movement)
{
  if (form_ == Form::observations || !movement.T_before_after.matrix().allFinite())
  {
    return;
  }
  if (form_ == Form::unknown)
  {
    ready_ = std::exchange(before_first_, std::nullopt);
  }
  form_ = Form::actions;
  pose_ = pose_ * movement.T_before_after;
  // Thousands of products: keep it a rotation.
  pose_.linear() = Eigen::Quaterniond(pose_.linear()).normalized().toRotationMatrix();
  action_stamp_ = movement.stamp;
}

void OdometryTrack::frameEnd()
{
  const auto frame_stamp = std::exchange(frame_stamp_, std::nullopt);
  const auto action_stamp = std::exchange(action_stamp_, std::nullopt);
  if (form_ == Form::observations)
  {
    return;
  }
  const auto stamp = frame_stamp ? frame_stamp : action_stamp;
  // A log without any movement has no odometry, whatever frames it has.
  std::optional<poses::StampedPose>& pose = form_ == Form::actions ? ready_ : before_first_;
  pose = poses::StampedPose{stamp.value_or(0), pose_};
}

std::optional<poses::StampedPose> OdometryTrack::take()
{
  return std::exchange(ready_, std::nullopt);
}
}  // namespace traverse::logs
