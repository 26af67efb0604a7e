// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "recording_time.h"

#include <traverse/geometry/exact_trig.h>
#include <traverse/poses/level_pose.h>
#include <traverse/simulation/pose_sensors.h>
#include <traverse/simulation/random.h>

#include <cmath>

namespace traverse::simulation
{
namespace
{
constexpr double kRadPerDegree = geometry::kPi / 180;

enum Purpose : uint64_t
{
  kNoise = 1,
  kLosses = 2,
};

double wrappedAngle(double angle_rad)
{
  return std::remainder(angle_rad, 2 * geometry::kPi);
}
}  // namespace

Ins::Ins(const InsParams& params, uint64_t seed) : params_(params), seed_(seed)
{
  options::check(params);
}

uint64_t Ins::posesUntil(double end_s) const
{
  return dueUntil(endWith(end_s, params_.dead_after_s), params_.rate_hz);
}

poses::TimeNs Ins::arrivalOf(uint64_t k) const
{
  return kRecordingStart + dueNs(k, params_.rate_hz) + nsOf(params_.late_s);
}

bool Ins::isLost(uint64_t k) const
{
  return params_.drop_out > 0 && Random(mixed({seed_, kLosses, k})).chance(params_.drop_out);
}

InsPose Ins::pose(uint64_t k, const Motion& drive) const
{
  const int64_t time_ns = dueNs(k, params_.rate_hz);
  Random random(mixed({seed_, kNoise, k}));
  InsPose pose;
  pose.stamp = kRecordingStart + time_ns + nsOf(params_.clock_offset_s);
  pose.arrival = arrivalOf(k);
  pose.label = params_.label;
  pose.T_map_base = drive.at(secondsOf(time_ns));
  pose.T_map_base.translation().x() += params_.noise_xy_m * random.normal();
  pose.T_map_base.translation().y() += params_.noise_xy_m * random.normal();
  pose.T_map_base.translation().z() += params_.noise_z_m * random.normal();
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  for (int axis = 0; axis < 3; ++axis)
  {
    const double angle_rad = params_.noise_deg * kRadPerDegree * random.normal();
    turn = turn * poses::rotationBy(angle_rad, Eigen::Vector3d::Unit(axis));
  }
  pose.T_map_base.linear() = pose.T_map_base.linear() * turn;
  return pose;
}

DeadReckoning::DeadReckoning(const OdometryParams& params, uint64_t seed) :
    params_(params), random_(mixed({seed, kNoise}))
{
  options::check(params);
}

void DeadReckoning::step(const geometry::Pose2& from, const geometry::Pose2& to)
{
  const geometry::SinCos h = geometry::sinCosOf(from.yaw_rad);
  const double dx = to.x_m - from.x_m;
  const double dy = to.y_m - from.y_m;
  const double way_m = std::sqrt(dx * dx + dy * dy);
  const double root = std::sqrt(way_m);
  const double factor = 1 + params_.scale_error;
  const double forward =
      factor * (h.cos * dx + h.sin * dy) + params_.noise_share * root * random_.normal();
  const double left = factor * (h.cos * dy - h.sin * dx);
  const geometry::SinCos own = geometry::sinCosOf(at_.yaw_rad);
  at_.x_m += own.cos * forward - own.sin * left;
  at_.y_m += own.sin * forward + own.cos * left;
  const double error_deg =
      params_.yaw_drift_degpm * way_m + params_.noise_degpm * root * random_.normal();
  at_.yaw_rad = wrappedAngle(at_.yaw_rad + (to.yaw_rad - from.yaw_rad) + error_deg * kRadPerDegree);
}

std::vector<OdometryPose> odometryOf(
    const Motion& drive, double end_s, const OdometryParams& params, uint64_t seed)
{
  DeadReckoning wheels(params, seed);
  const uint64_t count = dueUntil(end_s, params.rate_hz);
  std::vector<OdometryPose> poses;
  poses.reserve(count);
  geometry::Pose2 last = poses::seenFromAbove(drive.at(0));
  for (uint64_t k = 0; k < count; ++k)
  {
    const int64_t time_ns = dueNs(k, params.rate_hz);
    const geometry::Pose2 now = poses::seenFromAbove(drive.at(secondsOf(time_ns)));
    wheels.step(last, now);
    last = now;
    const poses::TimeNs arrival = kRecordingStart + time_ns;
    poses.push_back(
        {arrival + nsOf(params.clock_offset_s), arrival, params.label, wheels.at().x_m,
         wheels.at().y_m, wheels.at().yaw_rad});
  }
  return poses;
}
}  // namespace traverse::simulation
