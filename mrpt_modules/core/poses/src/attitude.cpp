// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "attitude.h"

#include <algorithm>
#include <cmath>

namespace traverse::poses
{
namespace
{
constexpr double kShortestCourse_m = 1.0;
constexpr double kSlowestCourse_mps = 0.5;
constexpr double kLongestCourse_s = 3.0;
constexpr double kLongestCoast_s = 30.0;

double wrapped(double angle_rad)
{
  return std::remainder(angle_rad, 2 * geometry::kPi);
}

Eigen::Matrix3d yawBy(double yaw_rad)
{
  return rotationBy(yaw_rad, Eigen::Vector3d::UnitZ());
}

double yawOf(const Eigen::Matrix3d& R)
{
  return geometry::angleOf(R(1, 0), R(0, 0));
}

/** Integral of the yaw rate at each sample. */
std::vector<AngleAt> turnsOf(const std::vector<ImuSample>& samples)
{
  std::vector<AngleAt> turns;
  double rate_before = 0;
  for (const ImuSample& sample : samples)
  {
    if (!sample.yaw_rate_radps)
    {
      continue;
    }
    const double rate = *sample.yaw_rate_radps;
    const double since_s = turns.empty() ? 0 : secondsBetween(turns.back().time, sample.time);
    const double before = turns.empty() ? 0 : turns.back().angle_rad;
    turns.push_back({sample.time, before + since_s * (rate + rate_before) / 2});
    rate_before = rate;
  }
  return turns;
}

/** By straight lines; the ends' values beyond them. Empty: 0. */
double angleAt(const std::vector<AngleAt>& angles, TimeNs time)
{
  const auto after = std::lower_bound(
      angles.begin(), angles.end(), time, [](const AngleAt& a, TimeNs t) { return a.time < t; });
  if (angles.empty() || after == angles.begin())
  {
    return angles.empty() ? 0 : angles.front().angle_rad;
  }
  if (after == angles.end())
  {
    return angles.back().angle_rad;
  }
  const AngleAt& before = *(after - 1);
  const double part = secondsBetween(before.time, time) / secondsBetween(before.time, after->time);
  return before.angle_rad + part * (after->angle_rad - before.angle_rad);
}
}  // namespace

std::vector<AngleAt> coursesOf(const std::vector<PlaneFix>& fixes)
{
  std::vector<AngleAt> courses;
  for (size_t i = 0; i < fixes.size(); ++i)
  {
    size_t from = i;
    size_t to = i;
    const auto chord = [&] { return Eigen::Vector2d((fixes[to].at - fixes[from].at).head<2>()); };
    const auto lasts_s = [&] { return secondsBetween(fixes[from].time, fixes[to].time); };
    // Grows to both sides evenly, so that in a bend the chord has the direction of the middle.
    while (from > 0 && to + 1 < fixes.size() && chord().norm() < kShortestCourse_m &&
           lasts_s() < kLongestCourse_s)
    {
      --from;
      ++to;
    }
    const double length_m = chord().norm();
    if (length_m >= kShortestCourse_m && lasts_s() <= kLongestCourse_s &&
        length_m >= kSlowestCourse_mps * lasts_s())
    {
      courses.push_back({fixes[i].time, geometry::angleOf(chord().y(), chord().x())});
    }
  }
  return courses;
}

Attitude::Attitude(
    const std::vector<ImuSample>& samples,
    const std::vector<AngleAt>& courses,
    const PoseParams& params) :
    max_age_s_(params.max_pose_age_s), turns_(turnsOf(samples))
{
  std::vector<StampedPose> oriented;
  for (const ImuSample& sample : samples)
  {
    if (sample.R_enu_base)
    {
      oriented.push_back({sample.time, Eigen::Isometry3d(*sample.R_enu_base)});
    }
  }
  full_ = !oriented.empty();
  constexpr double kAnyTurn_dps = 1e6;
  track_ = PoseTrack(std::move(oriented), {max_age_s_, params.max_speed_mps, kAnyTurn_dps});
  full_ ? compare(courses, params.ins_heading) : follow(courses);
}

std::optional<Eigen::Matrix3d> Attitude::at(TimeNs time) const
{
  if (full_)
  {
    const auto attitude = track_.at(time);
    return attitude
               ? std::optional<Eigen::Matrix3d>(yawBy(offset_rad_) * attitude->T_map_base.linear())
               : std::nullopt;
  }
  if (!nearCourse(time))
  {
    return std::nullopt;
  }
  return yawBy(angleAt(turns_, time) + angleAt(corrections_, time));
}

void Attitude::compare(const std::vector<AngleAt>& courses, InsHeading heading)
{
  double s = 0;
  double c = 0;
  for (const AngleAt& course : courses)
  {
    if (const auto attitude = track_.at(course.time))
    {
      const auto off =
          geometry::sinCosOfAny(course.angle_rad - yawOf(attitude->T_map_base.linear()));
      s += off.sin;
      c += off.cos;
    }
  }
  off_course_rad_ = geometry::angleOf(s, c);
  offset_rad_ = heading == InsHeading::course ? off_course_rad_ : 0;
}

/** What is to be added to the integrated rate at each course, without full turns between. */
void Attitude::follow(const std::vector<AngleAt>& courses)
{
  for (const AngleAt& course : courses)
  {
    const double plain = course.angle_rad - angleAt(turns_, course.time);
    const double before = corrections_.empty() ? plain : corrections_.back().angle_rad;
    corrections_.push_back({course.time, before + wrapped(plain - before)});
  }
}

bool Attitude::nearCourse(TimeNs time) const
{
  const double longest_s = turns_.empty() ? max_age_s_ : kLongestCoast_s;
  const auto after = std::lower_bound(
      corrections_.begin(), corrections_.end(), time,
      [](const AngleAt& a, TimeNs t) { return a.time < t; });
  const bool from_behind =
      after != corrections_.begin() && secondsBetween((after - 1)->time, time) <= longest_s;
  return from_behind ||
         (after != corrections_.end() && secondsBetween(time, after->time) <= longest_s);
}
}  // namespace traverse::poses
