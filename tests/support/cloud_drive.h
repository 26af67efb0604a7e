// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "synthetic_logs.h"

#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationRobotPose.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

// A drive with 3-D clouds and poses, and what may be wrong with its set-up.
namespace traverse::testing
{
struct DriveFaults
{
  double poses_late_s = 0;  //!< stamps of the poses
  double scans_late_s = 0;  //!< stamps of the scans of sensor "second"
  double pitch_deg = 0;     //!< of sensor "front", which its sensorPose does not have
  double yaw_deg = 0;       //!< so too
  double scale = 1;         //!< of the points
  bool camera_axes = false;
  bool second_sensor = false;
  double second_lower_m = 0;  //!< than its sensorPose says
};

/** 12 s at 6 m/s in bends of up to 30 deg/s. */
inline Eigen::Isometry3d driveAt(double t_s)
{
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  const double yaw = 0.5 * std::sin(t_s);
  T.linear() = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  // Along its own x axis: the integral of (cos yaw, sin yaw), in steps.
  for (int step = 0; step < std::lround(t_s * 100); ++step)
  {
    const double at = 0.5 * std::sin(0.01 * step + 0.005);
    T.translation() += 0.06 * Eigen::Vector3d(std::cos(at), std::sin(at), 0);
  }
  return T;
}

/** Ground, walls and poles of that road: map frame, ground at z = 0. */
inline std::vector<Eigen::Vector3d> roadside()
{
  std::mt19937 random(12);
  std::uniform_real_distribution<double> any(0, 1);
  std::vector<Eigen::Vector3d> things;
  things.reserve(26000);
  for (int i = 0; i < 20000; ++i)
  {
    things.emplace_back(140 * any(random) - 30, 60 * any(random) - 30, 0);
  }
  for (int i = 0; i < 6000; ++i)
  {
    const double x = 140 * any(random) - 30;
    const bool pole = any(random) < 0.4;
    const double y = any(random) < 0.5 ? -9.3 : 17.6;
    things.emplace_back(
        pole ? 6.7 * std::floor(x / 6.7) : x, pole ? y / 1.7 : y, 0.1 + 2.5 * any(random));
  }
  return things;
}

/** What a sensor 1.8 m above the vehicle's reference, which is on the ground, gives of it. */
inline mrpt::obs::CObservationPointCloud cloudAt(
    double t_s,
    const std::vector<Eigen::Vector3d>& things,
    const Eigen::Isometry3d& T_base_sensor,
    const Eigen::Matrix3d& axes,
    double scale)
{
  std::mt19937 random(static_cast<unsigned>(std::lround(t_s * 1000)));
  std::normal_distribution<float> noise(0, 0.02F);
  const Eigen::Isometry3d T_sensor_map = (driveAt(t_s) * T_base_sensor).inverse();
  auto points = mrpt::maps::CSimplePointsMap::Create();
  for (size_t i = random() % 4; i < things.size(); i += 4)
  {
    const Eigen::Vector3d p = T_sensor_map * things[i];
    if (p.norm() > 2.5 && p.norm() < 30)
    {
      const Eigen::Vector3f q = (scale * axes * p).cast<float>();
      points->insertPoint(q.x() + noise(random), q.y() + noise(random), q.z() + noise(random));
    }
  }
  mrpt::obs::CObservationPointCloud cloud;
  cloud.pointcloud = points;
  return cloud;
}

inline mrpt::Clock::time_point driveTime(double t_s)
{
  return observations::toTimePoint(kLogStart + static_cast<poses::TimeNs>(std::llround(t_s * 1e9)));
}

/** Clouds at 10 Hz, poses at 20 Hz. */
inline std::string cloudDrive(const DriveFaults& faults = {})
{
  constexpr double kDegree = std::numbers::pi / 180;
  const std::vector<Eigen::Vector3d> things = roadside();
  Eigen::Isometry3d mount = Eigen::Isometry3d::Identity();
  mount.translation().z() = 1.8;
  const Eigen::Isometry3d wrong(
      Eigen::AngleAxisd(faults.yaw_deg * kDegree, Eigen::Vector3d::UnitZ()) *
      Eigen::AngleAxisd(-faults.pitch_deg * kDegree, Eigen::Vector3d::UnitY()));
  Eigen::Isometry3d second = mount;
  second.translation().z() -= faults.second_lower_m;
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  if (faults.camera_axes)
  {
    axes << 0, -1, 0, 0, 0, -1, 1, 0, 0;
  }
  std::string log;
  for (int i = 0; i < 240; ++i)
  {
    const double t_s = 0.05 * i;
    mrpt::obs::CObservationRobotPose pose;
    pose.sensorLabel = "ins";
    pose.timestamp = driveTime(t_s + faults.poses_late_s);
    pose.pose.mean = observations::toPose3D(driveAt(t_s));
    log += serialised(pose);
    if (i % 2 == 0)
    {
      auto cloud = cloudAt(t_s, things, mount * wrong, axes, faults.scale);
      cloud.sensorLabel = "front";
      cloud.sensorPose = observations::toPose3D(mount);
      cloud.timestamp = driveTime(t_s);
      log += serialised(cloud);
    }
    else if (faults.second_sensor)
    {
      auto cloud = cloudAt(t_s, things, second, Eigen::Matrix3d::Identity(), 1);
      cloud.sensorLabel = "second";
      cloud.sensorPose = observations::toPose3D(mount);
      cloud.timestamp = driveTime(t_s + faults.scans_late_s);
      log += serialised(cloud);
    }
  }
  return log;
}
}  // namespace traverse::testing
