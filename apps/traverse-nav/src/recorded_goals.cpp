// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "recorded_goals.h"

#include <traverse/poses/level_pose.h>

#include <algorithm>
#include <limits>

namespace traverse::app
{
namespace
{
constexpr poses::TimeNs kForGood = std::numeric_limits<poses::TimeNs>::max();
}  // namespace

RecordedGoals::RecordedGoals(const poses::PoseTrack& track, const NavParams& params)
{
  if (params.goal_xs_m.empty())
  {
    alongTrack(track, params.goal_every_m);
  }
  else
  {
    ofIni(track, params);
  }
}

// Each until the vehicle was nearest to it.
void RecordedGoals::ofIni(const poses::PoseTrack& track, const NavParams& params)
{
  const auto poses = track.poses();
  size_t from = 0;
  for (size_t i = 0; i < params.goal_xs_m.size(); ++i)
  {
    const geometry::Pose2 goal = {params.goal_xs_m[i], params.goal_ys_m[i], 0};
    double least_m = std::numeric_limits<double>::infinity();
    for (size_t k = from; k < poses.size(); ++k)
    {
      const double away_m = geometry::distance_m(poses::seenFromAbove(poses[k].T_map_base), goal);
      from = away_m < least_m ? k : from;
      least_m = std::min(least_m, away_m);
    }
    const bool is_last = i + 1 == params.goal_xs_m.size();
    goals_.push_back(
        {{goal.x_m, goal.y_m, std::nullopt},
         is_last || poses.empty() ? kForGood : poses[from].time});
  }
}

void RecordedGoals::alongTrack(const poses::PoseTrack& track, double every_m)
{
  const auto poses = track.poses();
  double way_m = 0;
  double next_m = every_m;
  poses::TimeNs half_way = 0;
  for (size_t i = 0; i < poses.size(); ++i)
  {
    const geometry::Pose2 here = poses::seenFromAbove(poses[i].T_map_base);
    way_m += i > 0 ? geometry::distance_m(poses::seenFromAbove(poses[i - 1].T_map_base), here) : 0;
    half_way = half_way == 0 && way_m >= next_m - every_m / 2 ? poses[i].time : half_way;
    const bool is_last = i + 1 == poses.size();
    if (way_m >= next_m || is_last)
    {
      goals_.push_back({{here.x_m, here.y_m, std::nullopt}, is_last ? kForGood : half_way});
      next_m = way_m + every_m;
      half_way = 0;
    }
  }
}

std::optional<navigation::Goal> RecordedGoals::next(poses::TimeNs now)
{
  while (at_ + 1 < goals_.size() && goals_[at_].until <= now)
  {
    ++at_;
    is_new_ = true;
  }
  if (!is_new_ || goals_.empty())
  {
    return std::nullopt;
  }
  is_new_ = false;
  return goals_[at_].goal;
}
}  // namespace traverse::app
