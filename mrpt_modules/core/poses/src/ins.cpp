// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/poses/ins.h>

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
constexpr TimeNs kBetweenPoses = 10'000'000;
constexpr double kDegPerRad = 180 / geometry::kPi;

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

template <class T>
void sortByTime(std::vector<T>& all)
{
  std::stable_sort(all.begin(), all.end(), [](const T& a, const T& b) { return a.time < b.time; });
  const auto repeated =
      std::unique(all.begin(), all.end(), [](const T& a, const T& b) { return a.time == b.time; });
  all.erase(repeated, all.end());
}

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

/** Fixes of receivers that tell no height would jump between it and none. */
std::vector<PlaneFix> onPlane(const std::vector<GpsFix>& fixes, const geometry::Geodetic& origin)
{
  const geometry::LocalPlane plane(origin);
  const bool some_heights =
      std::any_of(fixes.begin(), fixes.end(), [](const GpsFix& f) { return f.has_height; });
  std::vector<PlaneFix> all;
  all.reserve(fixes.size());
  for (const GpsFix& fix : fixes)
  {
    geometry::Geodetic place = fix.place;
    place.height_m = fix.has_height ? place.height_m : origin.height_m;
    if (fix.has_height || !some_heights)
    {
      all.push_back({fix.time, plane.at(place), fix.antenna_base_m});
    }
  }
  return all;
}

/** The way driven about each fix, where it is long enough for a direction. */
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

/** The vehicle's attitude by time. */
class Attitude
{
 public:
  Attitude(
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

  std::optional<Eigen::Matrix3d> at(TimeNs time) const
  {
    if (full_)
    {
      const auto attitude = track_.at(time);
      return attitude ? std::optional<Eigen::Matrix3d>(
                            yawBy(offset_rad_) * attitude->T_map_base.linear())
                      : std::nullopt;
    }
    if (!nearCourse(time))
    {
      return std::nullopt;
    }
    return yawBy(angleAt(turns_, time) + angleAt(corrections_, time));
  }

  double off_course_rad() const { return off_course_rad_; }

 private:
  void compare(const std::vector<AngleAt>& courses, InsHeading heading)
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
  void follow(const std::vector<AngleAt>& courses)
  {
    for (const AngleAt& course : courses)
    {
      const double plain = course.angle_rad - angleAt(turns_, course.time);
      const double before = corrections_.empty() ? plain : corrections_.back().angle_rad;
      corrections_.push_back({course.time, before + wrapped(plain - before)});
    }
  }

  bool nearCourse(TimeNs time) const
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

  double max_age_s_;
  std::vector<AngleAt> turns_;
  std::vector<AngleAt> corrections_;
  PoseTrack track_;
  bool full_ = false;
  double offset_rad_ = 0;
  double off_course_rad_ = 0;
};

/** The vehicle's speed at a pose, from its neighbours. */
Eigen::Vector3d speedAt(const std::vector<StampedPose>& poses, size_t i)
{
  const StampedPose& a = poses[i == 0 ? 0 : i - 1];
  const StampedPose& b = poses[i + 1 == poses.size() ? i : i + 1];
  return (b.T_map_base.translation() - a.T_map_base.translation()) / secondsBetween(a.time, b.time);
}

/** On the cubic with the places and speeds at poses i and i + 1. */
Eigen::Vector3d between(const std::vector<StampedPose>& poses, size_t i, TimeNs time)
{
  const double h = secondsBetween(poses[i].time, poses[i + 1].time);
  const double u = secondsBetween(poses[i].time, time) / h;
  const double v = 1 - u;
  return (1 + 2 * u) * v * v * poses[i].T_map_base.translation() +
         u * u * (3 - 2 * u) * poses[i + 1].T_map_base.translation() +
         h * u * v * (v * speedAt(poses, i) - u * speedAt(poses, i + 1));
}

std::vector<StampedPose> withBetween(
    const std::vector<StampedPose>& at_fixes,
    const std::vector<ImuSample>& samples,
    const Attitude& attitude,
    double longest_gap_s)
{
  std::vector<StampedPose> all;
  size_t sample = 0;
  for (size_t i = 0; i < at_fixes.size(); ++i)
  {
    all.push_back(at_fixes[i]);
    const bool gap = i + 1 == at_fixes.size() ||
                     secondsBetween(at_fixes[i].time, at_fixes[i + 1].time) > longest_gap_s;
    for (; !gap && sample < samples.size() && samples[sample].time < at_fixes[i + 1].time; ++sample)
    {
      const TimeNs time = samples[sample].time;
      const bool roomy = time - all.back().time >= kBetweenPoses &&
                         at_fixes[i + 1].time - time >= kBetweenPoses / 2;
      const auto R = roomy ? attitude.at(time) : std::nullopt;
      if (R)
      {
        StampedPose pose{time, Eigen::Isometry3d(*R)};
        pose.T_map_base.translation() = between(at_fixes, i, time);
        all.push_back(pose);
      }
    }
  }
  return all;
}
}  // namespace

InsPoses insPoses(
    std::vector<GpsFix> fixes, std::vector<ImuSample> samples, const PoseParams& params)
{
  InsPoses result;
  sortByTime(fixes);
  sortByTime(samples);
  if (fixes.empty())
  {
    return result;
  }
  result.origin =
      params.ins_origin.size() == 3
          ? geometry::Geodetic{params.ins_origin[0], params.ins_origin[1], params.ins_origin[2]}
          : fixes.front().place;
  const std::vector<PlaneFix> on_plane = onPlane(fixes, *result.origin);
  const std::vector<AngleAt> courses = coursesOf(on_plane);
  const Attitude attitude(samples, courses, params);
  result.courses = courses.size();
  result.heading_off_course_deg = attitude.off_course_rad() * kDegPerRad;
  std::vector<StampedPose> at_fixes;
  at_fixes.reserve(on_plane.size());
  for (const PlaneFix& fix : on_plane)
  {
    if (const auto R = attitude.at(fix.time))
    {
      StampedPose pose{fix.time, Eigen::Isometry3d(*R)};
      pose.T_map_base.translation() = fix.at - *R * fix.antenna_base_m;
      at_fixes.push_back(pose);
    }
  }
  result.fixes_without_heading = on_plane.size() - at_fixes.size();
  result.poses = withBetween(at_fixes, samples, attitude, params.max_pose_age_s);
  return result;
}
}  // namespace traverse::poses
