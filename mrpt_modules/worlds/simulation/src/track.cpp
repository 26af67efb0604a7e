// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "refuse.h"
#include "site.h"
#include "strip.h"

#include <algorithm>
#include <cmath>

namespace traverse::simulation
{
namespace
{
constexpr double kStep_s = 0.1;
constexpr double kMostSteps = 100000;

/** The pose whose z axis is as near upright as the ground under it allows: on its four wheels. */
Eigen::Isometry3d onWheels(
    const ObjectParams& p,
    const Terrain& terrain,
    const Eigen::Vector2d& at,
    const Eigen::Vector2d& forward)
{
  const Eigen::Vector2d ahead = forward * (0.3 * p.length_m);
  const Eigen::Vector2d left = Eigen::Vector2d(-forward.y(), forward.x()) * (0.45 * p.width_m);
  const auto height = [&](const Eigen::Vector2d& q) { return terrain.at(q.x(), q.y()).height_m; };
  const double front_left = height(at + ahead + left);
  const double front_right = height(at + ahead - left);
  const double rear_left = height(at - ahead + left);
  const double rear_right = height(at - ahead - left);
  const double pitch = (front_left + front_right - rear_left - rear_right) / 2;
  const double roll = (front_left + rear_left - front_right - rear_right) / 2;
  const Eigen::Vector3d x = Eigen::Vector3d(2 * ahead.x(), 2 * ahead.y(), pitch);
  const Eigen::Vector3d y = Eigen::Vector3d(2 * left.x(), 2 * left.y(), roll);
  const Eigen::Vector3d z = x.cross(y);
  Eigen::Isometry3d T_map_body = Eigen::Isometry3d::Identity();
  T_map_body.linear().col(0) = x / std::sqrt(x.dot(x));
  T_map_body.linear().col(2) = z / std::sqrt(z.dot(z));
  T_map_body.linear().col(1) = T_map_body.linear().col(2).cross(T_map_body.linear().col(0));
  T_map_body.translation() << at.x(), at.y(),
      (front_left + front_right + rear_left + rear_right) / 4 + p.z_m;
  return T_map_body;
}

Eigen::Isometry3d onFeet(
    const ObjectParams& p,
    const Terrain& terrain,
    const Eigen::Vector2d& at,
    const Eigen::Vector2d& forward)
{
  Eigen::Isometry3d T_map_body = Eigen::Isometry3d::Identity();
  T_map_body.linear() << forward.x(), -forward.y(), 0, forward.y(), forward.x(), 0, 0, 0, 1;
  T_map_body.translation() << at.x(), at.y(), terrain.at(at.x(), at.y()).height_m + p.z_m;
  return T_map_body;
}
}  // namespace

Motion standingOnWheels(const ObjectParams& params, const Terrain& terrain)
{
  const auto [s, c] = geometry::sinCosOf(params.yaw_deg * (geometry::kPi / 180));
  return Motion({{0, onWheels(params, terrain, {params.x_m, params.y_m}, {c, s})}});
}

Motion motionOnTrack(const ObjectParams& params, const Terrain& terrain)
{
  const std::vector<Segment> line =
      lineThrough(params.track_xs_m, params.track_ys_m, "track_xs_m, track_ys_m");
  const double way_m = lengthOf(line);
  const double last = std::ceil(way_m / (params.speed_mps * kStep_s));
  if (last > kMostSteps)
  {
    refuse("speed_mps", params.speed_mps, "its track in less than 10000 s");
  }
  const bool wheels = params.kind == ObjectKind::vehicle;
  std::vector<TimedPose> poses;
  poses.reserve(static_cast<size_t>(last) + 1);
  for (int i = 0; i <= static_cast<int>(last); ++i)
  {
    const double along = std::min(way_m, i * kStep_s * params.speed_mps);
    const Eigen::Vector2d at = placeAlong(line, along);
    const Eigen::Vector2d forward = segmentAt(line, along).unit;
    poses.push_back(
        {params.start_s + i * kStep_s,
         wheels ? onWheels(params, terrain, at, forward) : onFeet(params, terrain, at, forward)});
  }
  return Motion(std::move(poses));
}
}  // namespace traverse::simulation
