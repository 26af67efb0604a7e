// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/options/option.h>
#include <traverse/poses/pose_track.h>

#include <array>
#include <string>
#include <utility>

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
  static constexpr std::array<std::pair<E, std::string_view>, 5> kNames = {
      {{E::identity, "identity"},
       {E::odometry, "odometry"},
       {E::robot_pose, "robot_pose"},
       {E::file, "file"},
       {E::icp_2d, "icp_2d"}}};
};
