// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "attitude.h"

#include <traverse/poses/ins.h>

#include <algorithm>
#include <map>

namespace traverse::poses
{
namespace
{
constexpr TimeNs kBetweenPoses = 10'000'000;
constexpr double kDegPerRad = 180 / geometry::kPi;

template <class T>
void sortByTime(std::vector<T>& all)
{
  std::stable_sort(all.begin(), all.end(), [](const T& a, const T& b) { return a.time < b.time; });
  const auto repeated =
      std::unique(all.begin(), all.end(), [](const T& a, const T& b) { return a.time == b.time; });
  all.erase(repeated, all.end());
}

/** Leaves the fixes of the receiver with most of them; returns how many are gone. */
size_t keepOneReceiver(std::vector<GpsFix>& fixes)
{
  std::map<uint32_t, size_t> fixes_of;
  for (const GpsFix& fix : fixes)
  {
    ++fixes_of[fix.receiver];
  }
  const auto most = std::max_element(
      fixes_of.begin(), fixes_of.end(),
      [](const auto& a, const auto& b) { return a.second < b.second; });
  return std::erase_if(fixes, [&](const GpsFix& fix) { return fix.receiver != most->first; });
}

/** The longest time between two fixes over which the way is filled in: a receiver that is slower
 * than max_pose_age_s has poses between its fixes all the same. */
double longestGap_s(const std::vector<StampedPose>& at_fixes, double max_age_s)
{
  constexpr double kPeriods = 2.5;
  constexpr double kMost_s = 5;
  if (at_fixes.size() < 2)
  {
    return max_age_s;
  }
  const double mean_s = secondsBetween(at_fixes.front().time, at_fixes.back().time) /
                        static_cast<double>(at_fixes.size() - 1);
  return std::max(max_age_s, std::min(kMost_s, kPeriods * mean_s));
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
  result.fixes_of_others = keepOneReceiver(fixes);
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
  result.heading_off_course_deg = attitude.offCourse_rad() * kDegPerRad;
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
  result.poses =
      withBetween(at_fixes, samples, attitude, longestGap_s(at_fixes, params.max_pose_age_s));
  return result;
}
}  // namespace traverse::poses
