// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "referee.h"
#include "robot_world.h"

#include <traverse/nav_app/closed_loop.h>
#include <traverse/simulation/decode_turn.h>
#include <traverse/simulation/random.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace traverse::app
{
namespace
{
using navigation::Conduct;

constexpr uint64_t kPoseNoise = 77;

/** Hands what the lidars saw to pose feed and pilot. */
void sense(RobotWorld& world, PoseFeed& poses, Pilot& pilot)
{
  for (const simulation::LidarTurn& turn : world.arrived())
  {
    points::Decoded seen = simulation::decodeTurn(turn);
    poses.see(seen.scan);
    pilot.take(seen, poses.track());
  }
}

/** Why the drive is over; nothing while it goes on. */
std::optional<std::string> endOf(
    const Pilot& pilot, const PilotStep& step, double t_s, const NavSettings& settings)
{
  if (step.conduct == Conduct::give_up)
  {
    return pilot.decisions().back().text;
  }
  if (t_s >= settings.run.max_time_s)
  {
    return fmt::format("max_time_s: {} s are over", settings.run.max_time_s);
  }
  return std::nullopt;
}
}  // namespace

DriveResult drive(
    const NavSettings& settings,
    const Mission& mission,
    uint64_t seed,
    Pilot& pilot,
    const DriveOptions& options)
{
  DriveResult result;
  Referee referee(result);
  RobotWorld world(settings, mission, seed);
  PoseFeed poses(
      settings.run.poses, settings.robot.odometry, world.truth(),
      simulation::mixed({seed, kPoseNoise}));
  pilot.goTo(mission.goals.at(0));
  PilotStep step;
  while (result.end.empty())
  {
    world.drive(step.command, 1 / settings.run.control_hz);
    poses.move(world.truth(), world.state().wheels);
    sense(world, poses, pilot);
    step = pilot.step(world.now(), poses.measured(), poses.pose(), world.state().wheels);
    DriveRecord record{world.t_s(), world.state(), poses.pose(), step, world.clearance_m()};
    referee.judge(record);
    result.records.push_back(record);
    if (options.watch)
    {
      options.watch(pilot, result);
    }
    if (step.conduct == Conduct::arrived)
    {
      result.reached = ++result.goals_reached == mission.goals.size();
      result.end = result.reached ? "arrived" : "";
      if (!result.reached)
      {
        pilot.goTo(mission.goals[result.goals_reached]);
      }
    }
    else
    {
      result.end = endOf(pilot, step, world.t_s(), settings).value_or("");
    }
    result.interrupted = options.stop != nullptr && *options.stop;
    result.end = result.interrupted ? "interrupted" : result.end;
  }
  result.time_s = world.t_s();
  return result;
}
}  // namespace traverse::app
