// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/geodesy.h>
#include <traverse/poses/pose_source.h>
#include <traverse/poses/pose_track.h>

#include <optional>
#include <vector>

namespace traverse::poses
{
/** Where a satellite antenna was. */
struct GpsFix
{
  TimeNs time = 0;
  geometry::Geodetic place;
  bool has_height = false;
  Eigen::Vector3d antenna_base_m = Eigen::Vector3d::Zero();  //!< its place on the vehicle
  uint32_t receiver = 0;                                     //!< which one, where there are several
};

/** What an inertial unit said. */
struct ImuSample
{
  TimeNs time = 0;
  /** The vehicle's attitude: takes its directions to x east, y north, z up. */
  std::optional<Eigen::Matrix3d> R_enu_base;
  std::optional<double> yaw_rate_radps;  //!< about the vehicle's z, counter-clockwise
};

/** The vehicle's way, and what it was made of. */
struct InsPoses
{
  std::vector<StampedPose> poses;
  std::optional<geometry::Geodetic> origin;  //!< of the map; nothing where there is no fix
  size_t fixes_of_others = 0;                //!< of receivers other than the one with most fixes
  size_t fixes_without_heading = 0;          //!< standing still, or the inertial unit silent
  size_t courses = 0;                        //!< fixes at which the way driven tells a heading
  double heading_off_course_deg = 0;         //!< mean of course less the inertial unit's heading
};

/** Poses by the receiver with most fixes (the first of several with as many: steps from one antenna
 * to another are no way driven), in the tangent plane at ins_origin, or at its first fix: at each
 * fix, and at most every 10 ms at inertial samples between two fixes (a cubic through the fixes).
 *
 * Attitude: of the inertial unit where it gives one, interpolated on SO(3). Else heading only, roll
 * and pitch 0: the course over ground (over 1 m at least, at 0.5 m/s at least, forwards), and
 * between courses what the yaw rate says, its drift taken out evenly; up to 30 s without a course
 * where there is a yaw rate, up to max_pose_age_s where there is none. Nothing is filtered: noise
 * of the fixes is noise of the poses. The same bits on every processor. */
InsPoses insPoses(
    std::vector<GpsFix> fixes, std::vector<ImuSample> samples, const PoseParams& params);
}  // namespace traverse::poses
