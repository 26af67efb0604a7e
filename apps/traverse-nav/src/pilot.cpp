// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cost_window.h"

#include <traverse/geometry/exact_trig.h>
#include <traverse/nav_app/pilot.h>
#include <traverse/navigation/cost_rules.h>
#include <traverse/navigation/grip.h>
#include <traverse/navigation/lead_in.h>
#include <traverse/navigation/obstacle_points.h>
#include <traverse/points/deskew.h>

#include <algorithm>
#include <cmath>

namespace traverse::app
{
namespace
{
using navigation::Conduct;
using navigation::Passage;
using navigation::Replan;
using poses::secondsBetween;

constexpr double kPlanAgain_s = 0.5;  // where there was no way
constexpr double kBackOff_mps = 0.2;

geometry::Pose2 placeOf(const navigation::Goal& goal)
{
  return {goal.x_m, goal.y_m, 0};
}
}  // namespace

Pilot::Pilot(
    const NavSettings& settings,
    const std::filesystem::path& cache,
    const std::filesystem::path& log_folder) :
    settings_(settings),
    maps_(buildMaps(settings.ini, settings.maps)),
    planner_(settings.robot.vehicle, settings.drivetrain, settings.plan),
    follower_(
        {settings.robot.vehicle, settings.drivetrain, settings.reactive, settings.speed},
        cache,
        log_folder),
    guard_(settings.robot.vehicle, settings.drivetrain, settings.guard),
    supervisor_(settings.watchdogs, settings.plan.goal_tolerance_m)
{
}

void Pilot::goTo(const navigation::Goal& goal)
{
  if (goal_)
  {
    supervisor_.nextGoal();
  }
  goal_ = goal;
  plan_ = {};
  last_plan_ = 0;
  follower_.follow({}, {});
}

void Pilot::startOver(const navigation::Goal& goal)
{
  goTo(goal);
  supervisor_.startOver();
}

bool Pilot::take(points::Decoded& decoded, const poses::PoseTrack& track)
{
  if (!track.at(decoded.scan.stamp) ||
      points::deskew(decoded.scan, track) == points::Deskew::no_poses)
  {
    return false;
  }
  const points::Scan scan = decoded.view();
  latencies_.time(
      Stage::maps,
      [&]
      {
        for (const BuiltMap& map : maps_)
        {
          has_news_ |= map.consumer->insertScan(scan, track).inserted;
        }
      });
  last_scan_ = std::max(last_scan_, scan.stamp);
  return true;
}

std::vector<layers::LayerSet> Pilot::layerSets(
    const geometry::CellRect& extent, const geometry::Lattice& lattice) const
{
  std::vector<layers::LayerSet> sets;
  const layers::LayerChoice wanted = navigation::costLayers();
  for (const BuiltMap& map : maps_)
  {
    sets.push_back(map.consumer->layerSet(windowOf(extent, lattice, latticeOf(map)), wanted));
  }
  return sets;
}

std::vector<navigation::MapLayers> Pilot::named(const std::vector<layers::LayerSet>& sets) const
{
  std::vector<navigation::MapLayers> layers;
  for (size_t i = 0; i < maps_.size(); ++i)
  {
    layers.push_back({maps_[i].title(), &sets[i]});
  }
  return layers;
}

std::vector<layers::Fact> Pilot::explain(double x_m, double y_m) const
{
  const std::vector<layers::LayerSet> sets = layerSets(costmap_.extent, costmap_.lattice);
  return navigation::explainCost(
      named(sets), costmap_, x_m, y_m, settings_.robot.vehicle, settings_.costs);
}

void Pilot::lookAtMaps(poses::TimeNs now, const geometry::Pose2& pose)
{
  if (!has_news_ || secondsBetween(last_look_, now) < 1 / settings_.run.costmap_hz)
  {
    return;
  }
  has_news_ = false;
  last_look_ = now;
  latencies_.time(
      Stage::costmap,
      [&]
      {
        const navigation::CostParams& params = settings_.costs;
        const geometry::Lattice lattice{
            static_cast<int32_t>(geometry::toMillimetres(params.cell_size_m))};
        const geometry::CellRect extent = around(pose, lattice, params.window_m);
        for (const BuiltMap& map : maps_)
        {
          map.consumer->advance(now);
        }
        const std::vector<layers::LayerSet> sets = layerSets(extent, lattice);
        costmap_ = navigation::costmapOf(
            named(sets), lattice, extent, pose, settings_.robot.vehicle, params);
      });
}

void Pilot::keepWay(poses::TimeNs now, const geometry::Pose2& pose, const geometry::Twist2& motion)
{
  if (!goal_ || costmap_.size() == 0)
  {
    return;
  }
  const Replan reason = plan_.path.empty()
                            ? Replan::first
                            : navigation::needsNewPlan(
                                  costmap_, settings_.robot.vehicle, plan_, pose, settings_.plan);
  const bool may_plan =
      last_plan_ == 0 || secondsBetween(last_plan_, now) >= kPlanAgain_s || !plan_.path.empty();
  if (reason == Replan::no || !may_plan)
  {
    return;
  }
  last_plan_ = now;
  ++plans_[static_cast<size_t>(reason)];
  plan_ = latencies_.time(Stage::plan, [&] { return planOnwards(pose, motion); });
  follower_.follow(plan_.path, pose);
}

navigation::Plan Pilot::planOnwards(const geometry::Pose2& pose, const geometry::Twist2& motion)
{
  if (settings_.drivetrain.steering == geometry::Steering::ackermann)
  {
    const navigation::Path lead = navigation::leadIn(pose, motion);
    navigation::Plan plan = lead.empty() ? navigation::Plan() : planToGoal(lead.back().pose);
    if (!plan.path.empty())
    {
      plan.path = navigation::joined(lead, plan.path);
      plan.way_out_m += plan.way_out_m > 0 ? lead.back().along_m : 0;
      return plan;
    }
  }
  return planToGoal(pose);
}

navigation::Plan Pilot::planToGoal(const geometry::Pose2& pose)
{
  if (!isGoalBlocked())
  {
    return planner_.plan(costmap_, pose, *goal_);
  }
  return planner_.planNear(costmap_, pose, *goal_);  // and looked at again on the way
}

bool Pilot::isGoalBlocked() const
{
  if (!goal_ || costmap_.size() == 0)
  {
    return false;
  }
  const Passage there = costmap_.passageAt(costmap_.cellAt(goal_->x_m, goal_->y_m));
  return there == Passage::obstacle || there == Passage::hard;
}

geometry::Twist2 Pilot::backOff(
    const geometry::Twist2& motion, std::span<const Eigen::Vector3f> obstacles) const
{
  const geometry::Twist2 back{-std::min(kBackOff_mps, settings_.drivetrain.max_reverse_mps), 0};
  return guard_.guarded(back, motion, obstacles);
}

void Pilot::heedStanding(const reactive::Senses& senses, const geometry::Twist2& command)
{
  constexpr double kStands_mps = 0.02;
  constexpr double kPatience_s = 1;
  const bool stands = plan_.heeds_footprint && std::abs(command.speed_mps) < kStands_mps &&
                      std::abs(senses.motion.speed_mps) < kStands_mps;
  standing_since_ = stands ? standing_since_.value_or(senses.now) : std::optional<poses::TimeNs>();
  if (stands && secondsBetween(*standing_since_, senses.now) >= kPatience_s)
  {
    standing_since_.reset();
    plan_ = {};
    follower_.follow({}, senses.pose);
  }
}

PilotStep Pilot::step(
    poses::TimeNs now,
    poses::TimeNs measured,
    const geometry::Pose2& pose,
    const geometry::Twist2& motion)
{
  last_scan_ = last_scan_ == 0 ? now : last_scan_;  // what came before is not waited for
  return latencies_.time(
      Stage::control,
      [&]
      {
        lookAtMaps(now, pose);
        keepWay(now, pose, motion);
        return latencies_.time(
            Stage::reactive, [&] { return decide(now, measured, pose, motion); });
      });
}

PilotStep Pilot::decide(
    poses::TimeNs now,
    poses::TimeNs measured,
    const geometry::Pose2& pose,
    const geometry::Twist2& motion)
{
  const navigation::SpeedLimit limit = follower_.limitAt(pose, motion, costmap_);
  reactive::Senses senses{now, pose, motion, {}, limit.speed_mps};
  guard_.standOn(navigation::frictionUnder(costmap_, settings_.robot.vehicle, pose));
  senses.obstacles =
      navigation::obstaclePoints(costmap_, pose, settings_.reactive.reference_distance_m + 1);
  const reactive::Command command = follower_.step(senses, guard_);
  navigation::Situation situation;
  situation.now = now;
  situation.last_scan = last_scan_;
  situation.last_pose = measured;
  situation.pose = pose;
  situation.has_way = !plan_.path.empty();
  situation.has_motion = command.outcome == reactive::Outcome::driving ||
                         command.outcome == reactive::Outcome::arrived;
  situation.wants_motion = command.twist.speed_mps != 0 || command.twist.yaw_rate_radps != 0;
  situation.is_goal_blocked = plan_.path.empty() && isGoalBlocked();
  situation.to_goal_m = goal_ ? geometry::distance_m(pose, placeOf(*goal_)) : 1e9;
  PilotStep result;
  result.conduct = supervisor_.step(situation);
  result.cause = supervisor_.log().back().cause;  // a step leaves a decision
  result.speed_limit_mps = limit.speed_mps;
  result.limited_by = limit.reason;
  if (result.conduct == Conduct::drive)
  {
    result.command = guard_.guarded(command.twist, motion, senses.obstacles);
  }
  else if (result.conduct == Conduct::recover)
  {
    result.command = backOff(motion, senses.obstacles);
    plan_ = {};
    follower_.follow({}, pose);
  }
  heedStanding(senses, result.command);
  return result;
}
}  // namespace traverse::app
