// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/points/scan.h>
#include <traverse/poses/pose_track.h>
#include <traverse/registration/align.h>
#include <traverse/registration/local_map.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace traverse::registration
{
/** How far odometry is believed, and when a pose no longer is. */
struct FollowParams
{
  double voxel_m = 0.5;     //!< edge of the map's voxels
  double max_range_m = 40;  //!< further points are left out, and the map is forgotten there

  // Standard deviations of what odometry tells of one metre; they grow with the root of the way.
  double along_m = 0.03;  //!< forwards
  double aside_m = 0.02;  //!< leftwards
  double up_m = 0.03;     //!< the ground is no plane
  double yaw_deg = 1;
  double tilt_deg = 4;
  double turn_share = 0.03;  //!< of a turn by one radian, rad; grows with the root of the turn

  double carried_m = 1;          //!< the way for which odometry carries on without a match
  double max_deviation_m = 0.3;  //!< a place known worse than this in some direction is none
};

/** What became of a scan. */
enum class Fit : uint8_t
{
  matched,         //!< it took part in the pose, as far as the map holds it
  began,           //!< the first scan of a lidar: its pose is odometry's
  no_odometry,     //!< none reaches its time
  too_few_points,  //!< within range, one per voxel
  little_overlap,  //!< too few of them on the map
  unsettled,       //!< the iterations did not come to rest
  contradicts,     //!< it lies where odometry cannot have come to
};

/** A scan's pose. */
struct Followed
{
  Fit fit = Fit::matched;
  Eigen::Isometry3d T_map_base = Eigen::Isometry3d::Identity();  //!< at the scan's stamp
  int iterations = 0;
  double deviation_m = 0;  //!< largest horizontal standard deviation of the place on the local map
};

/** The way of a vehicle with odometry, put right by its scans: each is predicted by the odometry
 * since the one before, and matched to a map of key frames.
 *
 * As in Kinematic-ICP (Guadagnino, Mersch, Vizzo, Gupta, Malladi, Lobefaro, Doisy, Stachniss:
 * "Kinematic-ICP", arXiv 2410.10277) the distance from odometry's prediction is minimised together
 * with those of the pairs; here it weighs by the covariance of the prediction, which grows with way
 * and turn, and shrinks with what each match tells (an error-state Kalman filter whose measurement
 * is the whole match). So a direction that the map leaves open stays odometry's, a standing vehicle
 * stays put, and no rule is needed for either. Where pairs and prediction disagree by more than
 * both allow (a wheel slips), the prediction counts for less. Key frames, each lidar's own, enter
 * the map some decimetres or degrees apart, if they matched. The pose is in 3-D, odometry in the
 * vehicle's present plane. The same bits on every processor: no libm. */
class OdometryToMap
{
 public:
  /** `T_map_odom`: where odometry's origin lies. Throws std::invalid_argument for what is not
   * positive. */
  OdometryToMap(const FollowParams& params, const Eigen::Isometry3d& T_map_odom);

  /** `scan` as decoded, before deskew(), of any lidar of the vehicle; `odometry`: T_odom_base
   * around its time. */
  Followed take(const points::ScanBuffer& scan, const poses::PoseTrack& odometry);

  /** Takes odometry's poses to the map: odometry carries on from the last match. */
  // NOLINTNEXTLINE(readability-identifier-naming)
  const Eigen::Isometry3d& T_map_odom() const { return T_map_odom_; }

  /** The stamp of the last scan whose pose is to be relied on: it was matched, or the way since the
   * last one that was is at most carried_m; and it is known to max_deviation_m. */
  std::optional<poses::TimeNs> reliedOn() const { return relied_on_; }

  const LocalMap& map() const { return map_; }

 private:
  /** A match and how well it is known then. */
  struct Estimate
  {
    Alignment found;
    Matrix6 covariance = Matrix6::Zero();
    double surprise = 0;  //!< squared Mahalanobis distance of pairs from prediction
  };

  Followed follow(
      const std::vector<Eigen::Vector3d>& points,
      const std::string& label,
      const Eigen::Isometry3d& predicted);
  Estimate estimate(
      const std::vector<Eigen::Vector3d>& points,
      const Eigen::Isometry3d& predicted,
      const Matrix6& covariance);
  void predict(const Eigen::Isometry3d& T_odom_base, poses::TimeNs stamp);
  void keep(
      const std::vector<Eigen::Vector3d>& points,
      const std::string& label,
      const Eigen::Isometry3d& T_map_base);

  FollowParams params_;
  LocalMap map_;
  Eigen::Isometry3d T_map_odom_;
  Eigen::Isometry3d T_odom_last_ = Eigen::Isometry3d::Identity();
  poses::TimeNs last_ = 0;  // of T_odom_last_
  bool began_ = false;
  Matrix6 covariance_ = Matrix6::Zero();  // of T_map_odom_ * T_odom_last_, on the local map
  double carried_m_ = 0;                  // since the last match
  std::map<std::string, Eigen::Isometry3d> key_frames_;  // each lidar's last
  std::optional<poses::TimeNs> relied_on_;
};
}  // namespace traverse::registration
