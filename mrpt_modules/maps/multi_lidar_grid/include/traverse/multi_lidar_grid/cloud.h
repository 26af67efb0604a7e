// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/points/scan.h>
#include <traverse/poses/pose_track.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <optional>
#include <vector>

namespace traverse::multi_lidar_grid
{
/** Where a sensor was while it took a cloud: at 20 m/s a turn begins 2 m from where it ends. */
class SensorPath
{
 public:
  /** `stamp`: of the scan, in the poses' time. Nothing without a pose there; times of points for
   * which there is none count as the stamp. */
  static std::optional<SensorPath> along(
      const points::Scan& scan, poses::TimeNs stamp, const poses::PoseTrack& track);

  /** T_map_base at the scan's stamp, to which its points were deskewed. */
  const Eigen::Isometry3d& pose() const { return T_map_base_; }

  /** The sensor in the map frame at a time relative to the stamp, m; for a time that is none, where
   * it was first. */
  Eigen::Vector3d originAt(float time_s) const
  {
    if (origins_.size() == 1)
    {
      return origins_.front();
    }
    const double steps = (time_s - first_s_) / step_s_;
    const double at = steps > 0 ? std::min(steps, static_cast<double>(origins_.size() - 1)) : 0;
    const auto before = std::min(static_cast<size_t>(at), origins_.size() - 2);
    const double part = at - static_cast<double>(before);
    return origins_[before] * (1 - part) + origins_[before + 1] * part;
  }

  /** The vehicle's attitude in the map at about that time. */
  const Eigen::Matrix3d& attitudeAt(float time_s) const
  {
    const double steps = (time_s - first_s_) / step_s_ + 0.5;
    const double last = static_cast<double>(attitudes_.size() - 1);
    return attitudes_[steps > 0 ? static_cast<size_t>(std::min(steps, last)) : 0];
  }

  /** Origins at first_s(), first_s() + step_s(), ...; one where the sensor stands still. */
  const std::vector<Eigen::Vector3d>& origins() const { return origins_; }

  double first_s() const { return first_s_; }

  double step_s() const { return step_s_; }

 private:
  Eigen::Isometry3d T_map_base_ = Eigen::Isometry3d::Identity();
  std::vector<Eigen::Vector3d> origins_ = {Eigen::Vector3d::Zero()};  // at equal steps of time
  std::vector<Eigen::Matrix3d> attitudes_ = {Eigen::Matrix3d::Identity()};
  double first_s_ = 0;
  double step_s_ = 1;
};

/** One sensor's cloud and where it was taken. */
struct Cloud
{
  points::Scan scan;        //!< deskewed
  poses::TimeNs stamp = 0;  //!< of the scan in the poses' time: with the clock's offset
  uint32_t sensor_bit = 1;  //!< one bit of 32
  SensorPath path;
};
}  // namespace traverse::multi_lidar_grid
