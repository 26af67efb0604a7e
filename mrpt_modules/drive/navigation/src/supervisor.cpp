// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "text.h"

#include <traverse/geometry/exact_trig.h>
#include <traverse/navigation/supervisor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace traverse::navigation
{
namespace
{
using poses::secondsBetween;

double turned_rad(const geometry::Pose2& a, const geometry::Pose2& b)
{
  const geometry::SinCos turn = geometry::sinCosOfAny(a.yaw_rad - b.yaw_rad);
  return std::abs(geometry::angleOf(turn.sin, turn.cos));
}

Decision decision(const Situation& now, Conduct conduct, Cause cause, std::string text)
{
  return {now.now, conduct, cause, std::move(text)};
}

std::string limitText(std::string_view key, double value)
{
  return " (" + std::string(key) + " = " + inShort(value) + ")";
}
}  // namespace

Supervisor::Supervisor(const WatchdogParams& params, double goal_tolerance_m) :
    params_(params), goal_tolerance_m_(goal_tolerance_m)
{
  options::check(params_);
}

Conduct Supervisor::step(const Situation& situation)
{
  Decision next = judge(situation);
  const Conduct conduct = next.conduct;
  if (log_.empty() || log_.back().conduct != conduct || log_.back().cause != next.cause)
  {
    log_.push_back(std::move(next));
  }
  return conduct;
}

void Supervisor::nextGoal()
{
  forgetWaiting();
  if (final_ && final_->conduct == Conduct::arrived)
  {
    final_.reset();
  }
}

void Supervisor::startOver()
{
  forgetWaiting();
  final_.reset();
  recoveries_ = 0;
}

void Supervisor::forgetWaiting()
{
  hindered_since_.reset();
  stuck_from_.reset();
  recover_until_.reset();
}

Decision Supervisor::judge(const Situation& now)
{
  if (final_)
  {
    return *final_;
  }
  const Verdict jumped = jump(now);
  const Verdict blind = senses(now);
  if (jumped || blind)
  {
    forgetWaiting();
    return blind ? *blind : *jumped;
  }
  if (now.to_goal_m <= goal_tolerance_m_)
  {
    final_ = decision(
        now, Conduct::arrived, Cause::arrived, "the goal is " + inShort(now.to_goal_m) + " m away");
    return *final_;
  }
  if (recover_until_ && now.now < *recover_until_)
  {
    return decision(now, Conduct::recover, recover_cause_, "backs off");
  }
  recover_until_.reset();
  if (!now.has_way)
  {
    return withoutWay(now);
  }
  if (!now.has_motion || !now.wants_motion)
  {
    return withoutMotion(now);
  }
  hindered_since_.reset();
  if (const Verdict no_progress = stuck(now))
  {
    return *no_progress;
  }
  return decision(
      now, Conduct::drive, Cause::none, "drives, " + inShort(now.to_goal_m) + " m to the goal");
}

Supervisor::Verdict Supervisor::senses(const Situation& now) const
{
  const double pose_age_s = secondsBetween(now.last_pose, now.now);
  if (pose_age_s > params_.max_pose_age_s)
  {
    return decision(
        now, Conduct::stop, Cause::stale_pose,
        "no newer pose for " + inShort(pose_age_s) + " s" +
            limitText("max_pose_age_s", params_.max_pose_age_s));
  }
  const double map_age_s = secondsBetween(now.last_scan, now.now);
  if (map_age_s > params_.max_map_age_s)
  {
    return decision(
        now, Conduct::stop, Cause::stale_map,
        "no newer scan in the maps for " + inShort(map_age_s) + " s" +
            limitText("max_map_age_s", params_.max_map_age_s));
  }
  return std::nullopt;
}

Supervisor::Verdict Supervisor::jump(const Situation& now)
{
  const double elapsed_s = before_ ? secondsBetween(before_->last_pose, now.last_pose) : 0;
  const double moved_m = before_ ? geometry::distance_m(before_->pose, now.pose) : 0;
  const bool is_place = std::isfinite(now.pose.x_m + now.pose.y_m + now.pose.yaw_rad);
  const double foreseen_m = last_speed_mps_ * std::max(elapsed_s, 0.0);
  if (!is_place || moved_m - foreseen_m > params_.max_pose_jump_m)
  {
    jumped_ = now.now;
    jumped_by_m_ = moved_m;
    last_speed_mps_ = 0;
  }
  else if (elapsed_s > 0)
  {
    last_speed_mps_ = moved_m / elapsed_s;
  }
  before_ = is_place ? now : before_;
  const double steady_s = jumped_ ? secondsBetween(*jumped_, now.now) : kSettle_s;
  if (steady_s >= kSettle_s)
  {
    jumped_.reset();
    return std::nullopt;
  }
  return decision(
      now, Conduct::stop, Cause::lost_pose,
      "the pose jumped by " + inShort(jumped_by_m_) + " m" +
          limitText("max_pose_jump_m", params_.max_pose_jump_m));
}

double Supervisor::hinderedFor_s(const Situation& now)
{
  stuck_from_.reset();
  hindered_since_ = hindered_since_.value_or(now.now);
  return secondsBetween(*hindered_since_, now.now);
}

Decision Supervisor::withoutWay(const Situation& now)
{
  const double since_s = hinderedFor_s(now);
  const Cause cause = now.is_goal_blocked ? Cause::goal_in_obstacle : Cause::no_way;
  const std::string what = now.is_goal_blocked ? "the goal lies in an obstacle or its hard buffer, "
                                               : "there is no way, ";
  const std::string goal = inShort(now.to_goal_m) + " m from the goal";
  if (since_s >= params_.no_way_s)
  {
    final_ = decision(
        now, Conduct::give_up, cause,
        what + goal + ", for " + inShort(since_s) + " s" + limitText("no_way_s", params_.no_way_s));
    return *final_;
  }
  return decision(now, Conduct::stop, cause, what + goal);
}

Decision Supervisor::withoutMotion(const Situation& now)
{
  const double since_s = hinderedFor_s(now);
  const std::string what = now.has_motion ? "the command is to stand" : "no motion is found";
  const bool backs_off = !now.is_goal_blocked && recoveries_ < params_.most_recoveries;
  const Cause cause = now.is_goal_blocked ? Cause::goal_in_obstacle : Cause::blocked;
  if (backs_off && since_s >= params_.no_way_s / 2)
  {
    return recover(now, cause, what + " for " + inShort(since_s) + " s");
  }
  if (since_s >= params_.no_way_s)
  {
    final_ = decision(
        now, Conduct::give_up, cause,
        what + " for " + inShort(since_s) + " s" + limitText("no_way_s", params_.no_way_s) +
            ", after " + std::to_string(recoveries_) + " recoveries, " + inShort(now.to_goal_m) +
            " m from the goal");
    return *final_;
  }
  return decision(now, Conduct::stop, cause, what + ", though there is a way");
}

Supervisor::Verdict Supervisor::stuck(const Situation& now)
{
  const bool got_on = !stuck_from_ ||
                      geometry::distance_m(*stuck_from_, now.pose) > params_.stuck_m ||
                      turned_rad(*stuck_from_, now.pose) > kTurned_rad;
  if (got_on)
  {
    stuck_from_ = now.pose;
    stuck_since_ = now.now;
    return std::nullopt;
  }
  const double since_s = secondsBetween(stuck_since_, now.now);
  if (since_s < params_.stuck_s)
  {
    return std::nullopt;
  }
  const std::string why = "came no further than " + inShort(params_.stuck_m) + " m in " +
                          inShort(since_s) + " s" + limitText("stuck_s", params_.stuck_s);
  if (recoveries_ >= params_.most_recoveries)
  {
    final_ = decision(
        now, Conduct::give_up, Cause::stuck,
        why + ", after " + std::to_string(recoveries_) + " recoveries");
    return final_;
  }
  return recover(now, Cause::stuck, why);
}

Decision Supervisor::recover(const Situation& now, Cause cause, const std::string& why)
{
  forgetWaiting();
  ++recoveries_;
  recover_until_ = poses::later(now.now, kBackOff_s);
  recover_cause_ = cause;
  return decision(
      now, Conduct::recover, cause,
      why + ": backs off, recovery " + std::to_string(recoveries_) + " of " +
          std::to_string(params_.most_recoveries));
}

std::string_view nameOf(Conduct conduct)
{
  constexpr std::array<std::string_view, 5> kNames = {
      "drive", "stop", "recover", "give_up", "arrived"};
  return kNames.at(static_cast<size_t>(conduct));
}

std::string_view nameOf(Cause cause)
{
  constexpr std::array<std::string_view, 9> kNames = {"none",      "stale_map",        "stale_pose",
                                                      "lost_pose", "no_way",           "blocked",
                                                      "stuck",     "goal_in_obstacle", "arrived"};
  return kNames.at(static_cast<size_t>(cause));
}
}  // namespace traverse::navigation
