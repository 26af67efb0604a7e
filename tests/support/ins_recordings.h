// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geodetic_path.h"
#include "path_errors.h"

#include <traverse/poses/ins.h>

#include <algorithm>
#include <cstdio>
#include <random>
#include <support/data.h>

// Real ways of cars, and what a receiver and an inertial unit would say on them.
namespace traverse::testing
{
inline constexpr poses::TimeNs kStart = 1'600'000'000'000'000'000;

inline std::vector<poses::StampedPose> argoversePath()
{
  const std::vector<char> bytes =
      unpacked(sharedData("argoverse2-2xVLP32C/city_SE3_egovehicle.csv.gz"));
  std::string all(bytes.begin(), bytes.end());
  std::replace(all.begin(), all.end(), ',', ' ');
  std::istringstream text(all);
  std::string header;
  std::getline(text, header);
  std::vector<poses::StampedPose> path;
  poses::TimeNs time = 0;
  double w = 0, x = 0, y = 0, z = 0;
  while (text >> time >> w >> x >> y >> z)
  {
    poses::StampedPose pose{time, Eigen::Isometry3d(Eigen::Quaterniond(w, x, y, z).normalized())};
    text >> pose.T_map_base.translation().x() >> pose.T_map_base.translation().y() >>
        pose.T_map_base.translation().z();
    path.push_back(pose);
  }
  return path;
}

/** 2021-10-26-16-21-29-468 (all of one hour), then a 3x4. */
inline std::vector<poses::StampedPose> novatelPath()
{
  const auto file = sharedData("multilidar-ins-stationary/NovAtel-pose-lidar-time.txt.gz");
  const std::vector<char> bytes = unpacked(file);
  std::istringstream text(std::string(bytes.begin(), bytes.end()));
  const Path rows = readRows(file, 1);
  std::vector<poses::StampedPose> path;
  std::string line;
  while (std::getline(text, line) && path.size() < rows.size())
  {
    int year = 0, month = 0, day = 0, hour = 0, minute = 0, second = 0, ms = 0;
    std::sscanf(
        line.c_str(), "%d-%d-%d-%d-%d-%d-%d", &year, &month, &day, &hour, &minute, &second, &ms);
    const int64_t in_ms = ((hour * 60 + minute) * 60 + second) * 1000LL + ms;
    path.push_back({kStart + in_ms * 1'000'000, rows[path.size()]});
  }
  return path;
}

struct Noise
{
  double horizontal_m = 0;
  double vertical_m = 0;
  double attitude_deg = 0;
};

/** GPS at 10 Hz and an inertial unit at 100 Hz on that path. */
inline poses::InsPoses observed(
    const poses::PoseTrack& truth, const Noise& noise, bool with_attitude)
{
  const geometry::Geodetic origin{40.44, -79.99, 230};
  const Eigen::Vector3d antenna(-0.4, 0.1, 1.5);
  std::mt19937_64 random(7);
  std::normal_distribution<double> any(0, 1);
  std::vector<poses::GpsFix> fixes;
  std::vector<poses::ImuSample> samples;
  const Eigen::Isometry3d T_local_map = truth.poses().front().T_map_base.inverse();
  const poses::TimeNs begin = truth.poses().front().time;
  const poses::TimeNs end = truth.poses().back().time;
  std::optional<double> yaw_before;
  for (poses::TimeNs t = begin; t <= end; t += 10'000'000)
  {
    const Eigen::Isometry3d T = T_local_map * truth.at(t)->T_map_base;
    if ((t - begin) % 100'000'000 == 0)
    {
      const Eigen::Vector3d off(
          noise.horizontal_m * any(random), noise.horizontal_m * any(random),
          noise.vertical_m * any(random));
      fixes.push_back({t, placeAt(origin, T * antenna + off), true, antenna});
    }
    const double yaw = std::atan2(T.linear()(1, 0), T.linear()(0, 0));
    const double rate =
        yaw_before ? std::remainder(yaw - *yaw_before, 2 * geometry::kPi) / 0.01 : 0;
    yaw_before = yaw;
    const Eigen::Vector3d turn(any(random), any(random), any(random));
    const Eigen::Matrix3d R =
        T.linear() *
        poses::rotationBy(turn.norm() * noise.attitude_deg / kDegPerRad, turn.normalized());
    samples.push_back({t, with_attitude ? std::optional(R) : std::nullopt, rate});
  }
  poses::PoseParams params;
  params.ins_origin = {origin.latitude_deg, origin.longitude_deg, origin.height_m};
  return poses::insPoses(fixes, samples, params);
}

}  // namespace traverse::testing
