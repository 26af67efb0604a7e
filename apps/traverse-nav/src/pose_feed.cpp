// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pose_feed.h"

#include <traverse/geometry/exact_trig.h>

#include <cmath>

namespace traverse::app
{
namespace
{
constexpr double kKept_s = 1.5;

/** Heading of a frame's x axis seen from above. */
double yawOf(const Eigen::Isometry3d& T)
{
  return geometry::angleOf(T.linear()(1, 0), T.linear()(0, 0));
}

registration::Params matcherParams()
{
  registration::Params params;
  params.max_range_m = 60;
  return params;
}
}  // namespace

PoseFeed::PoseFeed(
    NavPoses source,
    const simulation::OdometryParams& odometry,
    const poses::StampedPose& start,
    uint64_t seed) :
    source_(source),
    odometry_(odometry),
    random_(seed),
    T_map_start_(start.T_map_base),
    matcher_(matcherParams()),
    measured_(start.time)
{
  if (source == NavPoses::exact)
  {
    moved_.push_back(start);
  }
  else
  {
    T_map_odom_ = start.T_map_base;
    moved_.push_back({start.time, Eigen::Isometry3d::Identity()});
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
  const double way_m = wheels.speed_mps * dt_s;
  const double noise = std::sqrt(std::abs(way_m));
  const double turn_deg = odometry_.yaw_drift_degpm * std::abs(way_m) +
                          odometry_.noise_degpm * noise * random_.normal();
  const double turn_rad = wheels.yaw_rate_radps * dt_s + turn_deg * geometry::kPi / 180;
  const double seen_m =
      way_m * (1 + odometry_.scale_error) + odometry_.noise_share * noise * random_.normal();
  Eigen::Isometry3d step = Eigen::Isometry3d::Identity();
  step.linear() = poses::rotationBy(turn_rad, Eigen::Vector3d::UnitZ());
  const geometry::SinCos half = geometry::sinCosOfAny(turn_rad / 2);
  step.translation() = Eigen::Vector3d(seen_m * half.cos, seen_m * half.sin, 0);
  moved_.push_back({truth.time, last.T_map_base * step});
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
  const registration::Matched matched = matcher_.take(scan);
  const auto odometry = poses::PoseTrack(moved_).at(scan.stamp);
  if (matched.verdict == registration::Verdict::waiting)
  {
    measured_ = scan.stamp;
  }
  if (matched.verdict == registration::Verdict::tracked && odometry)
  {
    T_map_odom_ = T_map_start_ * matched.T_map_base * odometry->T_map_base.inverse();
    measured_ = scan.stamp;
  }
}

poses::PoseTrack PoseFeed::track() const
{
  std::vector<poses::StampedPose> placed = moved_;
  for (poses::StampedPose& pose : placed)
  {
    pose.T_map_base = T_map_odom_ * pose.T_map_base;
  }
  return poses::PoseTrack(std::move(placed));
}

geometry::Pose2 PoseFeed::pose() const
{
  const Eigen::Isometry3d T_map_base = T_map_odom_ * moved_.back().T_map_base;
  return {T_map_base.translation().x(), T_map_base.translation().y(), yawOf(T_map_base)};
}
}  // namespace traverse::app
