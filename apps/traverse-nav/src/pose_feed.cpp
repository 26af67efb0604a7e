// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pose_feed.h"

#include <traverse/geometry/exact_trig.h>
#include <traverse/poses/level_pose.h>

#include <cmath>

namespace traverse::app
{
namespace
{
constexpr double kKept_s = 1.5;

/** Where wheels that turn so come to, along an arc. */
geometry::Pose2 rolled(const geometry::Pose2& from, const geometry::Twist2& wheels, double dt_s)
{
  const double way_m = wheels.speed_mps * dt_s;
  const double turn_rad = wheels.yaw_rate_radps * dt_s;
  const geometry::SinCos chord = geometry::sinCosOfAny(from.yaw_rad + turn_rad / 2);
  return {from.x_m + way_m * chord.cos, from.y_m + way_m * chord.sin, from.yaw_rad + turn_rad};
}
}  // namespace

PoseFeed::PoseFeed(
    NavPoses source,
    const simulation::OdometryParams& odometry,
    const poses::StampedPose& start,
    uint64_t seed) :
    source_(source),
    odometry_(odometry, seed),
    moved_{start},
    matcher_({}, source == NavPoses::exact ? Eigen::Isometry3d::Identity() : start.T_map_base),
    measured_(start.time)
{
  if (source != NavPoses::exact)
  {
    moved_.front().T_map_base.setIdentity();
  }
}

void PoseFeed::move(const poses::StampedPose& truth, const geometry::Twist2& wheels)
{
  if (source_ == NavPoses::exact)
  {
    moved_.push_back(truth);
    measured_ = truth.time;
    dropOld();
    return;
  }
  const poses::StampedPose& last = moved_.back();
  const double dt_s = poses::secondsBetween(last.time, truth.time);
  const geometry::Pose2 before = rolled_;
  rolled_ = rolled(before, wheels, dt_s);
  odometry_.step(before, rolled_);
  moved_.push_back({truth.time, poses::levelPose(odometry_.at())});
  dropOld();
}

void PoseFeed::dropOld()
{
  const auto is_old = [&](const poses::StampedPose& pose)
  { return poses::secondsBetween(pose.time, moved_.back().time) > kKept_s; };
  std::erase_if(moved_, is_old);
}

void PoseFeed::see(const points::ScanBuffer& scan)
{
  if (source_ == NavPoses::exact)
  {
    return;
  }
  matcher_.take(scan, poses::PoseTrack(moved_));
  measured_ = matcher_.reliedOn().value_or(measured_);
}

poses::PoseTrack PoseFeed::track() const
{
  std::vector<poses::StampedPose> placed = moved_;
  for (poses::StampedPose& pose : placed)
  {
    pose.T_map_base = matcher_.T_map_odom() * pose.T_map_base;
  }
  return poses::PoseTrack(std::move(placed));
}

geometry::Pose2 PoseFeed::pose() const
{
  return poses::seenFromAbove(matcher_.T_map_odom() * moved_.back().T_map_base);
}
}  // namespace traverse::app
