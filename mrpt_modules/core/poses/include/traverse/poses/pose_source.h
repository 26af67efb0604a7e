// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/options/option.h>
#include <traverse/poses/pose_track.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace traverse::poses
{
/** Where the poses of a run come from. */
enum class PoseSource : uint8_t
{
  identity,    //!< a robot that stands still, or a single scan
  odometry,    //!< CObservationOdometry, or action/observation pairs
  robot_pose,  //!< CObservationRobotPose
  file,        //!< a TUM or KITTI trajectory
  icp_2d,      //!< MRPT's ICP SLAM on 2-D scans
  icp_3d,      //!< scans to a map of those before them
  ins,         //!< GPS and IMU in a local plane
};

/** What an IMU's yaw counts from. */
enum class InsHeading : uint8_t
{
  imu,     //!< east
  course,  //!< something constant
};

/** Section [Poses]. */
struct PoseParams
{
  PoseSource source = PoseSource::odometry;
  std::string file;
  std::string times_file;
  double max_pose_age_s = 1.0;
  double max_speed_mps = 60.0;
  double max_turn_dps = 720.0;
  double icp_3d_voxel_m = 0.0;
  double icp_3d_max_range_m = 100.0;
  std::vector<double> ins_origin;
  std::vector<double> ins_fix_qualities = {1, 2, 3, 4, 5, 9};
  InsHeading ins_heading = InsHeading::imu;
  std::string ins_receiver;

  TrackLimits limits() const { return {max_pose_age_s, max_speed_mps, max_turn_dps}; }
};

template <class P, class F>
void visitPoseParams(P& p, F&& f)
{
  using options::Option;
  f(Option{"source", "where the poses come from"}, p.source);
  f(Option{"file", "for source = file: trajectory, TUM (t x y z qx qy qz qw) or KITTI (3x4 rows)"},
    p.file);
  f(Option{"times_file", "for a KITTI trajectory: one time per row, s"}, p.times_file);
  f(
      Option{
          "max_pose_age_s",
          "a pose is valid for so long, s; a scan without one is skipped",
          {1e-3, 3600}},
      p.max_pose_age_s);
  f(
      Option{
          "max_speed_mps",
          "a faster displacement is a jump: a new segment begins, m/s",
          {0.01, 1000}},
      p.max_speed_mps);
  f(Option{"max_turn_dps", "so does a faster turn, deg/s", {1, 36000}}, p.max_turn_dps);
  f(
      Option{
          "icp_3d_voxel_m",
          "for source = icp_3d: edge of its map's voxels, m; 0: a 30th of the range that 9 of 10 "
          "points of the first scan lie within, 0.05 to 1 m",
          {0, 10}},
      p.icp_3d_voxel_m);
  f(
      Option{
          "icp_3d_max_range_m",
          "for source = icp_3d: further points are not matched, m",
          {1, 1000}},
      p.icp_3d_max_range_m);
  f(
      Option{
          "ins_origin",
          "for source = ins: latitude and longitude (deg) and ellipsoidal height (m) of the map's "
          "origin; empty: the first good fix",
          {-100000, 100000}},
      p.ins_origin);
  f(
      Option{
          "ins_fix_qualities",
          "for source = ins: NMEA GGA qualities to take (1 GPS, 2 DGPS, 4 RTK fixed, 5 RTK float, "
          "6 "
          "estimated, 8 simulated; 9 stands for what NovAtel calls good)",
          {0, 9}},
      p.ins_fix_qualities);
  f(
      Option{
          "ins_heading",
          "for source = ins: imu: its yaw counts from east, counter-clockwise; course: its yaw has "
          "an unknown offset, told from the way driven (forwards)"},
      p.ins_heading);
  f(
      Option{
          "ins_receiver",
          "for source = ins: label of the GPS receiver to take; empty: the one with most good "
          "fixes"},
      p.ins_receiver);
}

template <class F>
void visit(PoseParams& p, F&& f)
{
  visitPoseParams(p, f);
}

template <class F>
void visit(const PoseParams& p, F&& f)
{
  visitPoseParams(p, f);
}
}  // namespace traverse::poses

template <>
struct traverse::options::EnumNames<traverse::poses::PoseSource>
{
  using E = traverse::poses::PoseSource;
  static constexpr std::array<std::pair<E, std::string_view>, 7> kNames = {
      {{E::identity, "identity"},
       {E::odometry, "odometry"},
       {E::robot_pose, "robot_pose"},
       {E::file, "file"},
       {E::icp_2d, "icp_2d"},
       {E::icp_3d, "icp_3d"},
       {E::ins, "ins"}}};
};

template <>
struct traverse::options::EnumNames<traverse::poses::InsHeading>
{
  using E = traverse::poses::InsHeading;
  static constexpr std::array<std::pair<E, std::string_view>, 2> kNames = {
      {{E::imu, "imu"}, {E::course, "course"}}};
};
