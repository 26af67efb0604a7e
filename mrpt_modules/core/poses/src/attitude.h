// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/poses/ins.h>

#include <optional>
#include <vector>

namespace traverse::poses
{
/** A value of an angle at a time, rad. */
struct AngleAt
{
  TimeNs time = 0;
  double angle_rad = 0;
};

/** Where the antenna was, in the plane. */
struct PlaneFix
{
  TimeNs time = 0;
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  Eigen::Vector3d antenna_base_m = Eigen::Vector3d::Zero();
};

/** The way driven about each fix, where it is long enough for a direction. */
std::vector<AngleAt> coursesOf(const std::vector<PlaneFix>& fixes);

/** The vehicle's attitude by time: of the inertial unit, or from courses and yaw rates. */
class Attitude
{
 public:
  Attitude(
      const std::vector<ImuSample>& samples,
      const std::vector<AngleAt>& courses,
      const PoseParams& params);

  std::optional<Eigen::Matrix3d> at(TimeNs time) const;

  /** Mean of course less the inertial unit's heading. */
  double offCourse_rad() const { return off_course_rad_; }

 private:
  void compare(const std::vector<AngleAt>& courses, InsHeading heading);
  void follow(const std::vector<AngleAt>& courses);
  bool nearCourse(TimeNs time) const;

  double max_age_s_;
  std::vector<AngleAt> turns_;
  std::vector<AngleAt> corrections_;
  PoseTrack track_;
  bool full_ = false;
  double offset_rad_ = 0;
  double off_course_rad_ = 0;
};
}  // namespace traverse::poses
