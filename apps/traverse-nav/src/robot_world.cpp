// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "robot_world.h"

#include <traverse/simulation/random.h>

#include <algorithm>

namespace traverse::app
{
namespace
{
constexpr double kFarClearance_m = 5;
constexpr double kTurnReach_s = 1.2;  // a turn's beginning lies no further back

std::vector<simulation::Lidar> lidarsOf(const simulation::RecordingParams& robot, uint64_t seed)
{
  std::vector<simulation::Lidar> lidars;
  for (size_t i = 0; i < robot.lidars.size(); ++i)
  {
    lidars.emplace_back(robot.lidars[i], simulation::mixed({seed, i}));
  }
  return lidars;
}
}  // namespace

RobotWorld::RobotWorld(const NavSettings& settings, const Mission& mission, uint64_t seed) :
    caster_(mission.scene),
    surroundings_(mission.scene, settings.robot.vehicle),
    vehicle_(mission.scene.terrain, settings.robot.vehicle, settings.drivetrain, mission.start),
    lidars_(lidarsOf(settings.robot, seed)),
    next_turns_(lidars_.size(), 0)
{
}

void RobotWorld::drive(const geometry::Twist2& command, double dt_s)
{
  vehicle_.step(command, dt_s);
}

poses::TimeNs RobotWorld::now() const
{
  return poses::later(simulation::kRecordingStart, t_s());
}

std::vector<simulation::LidarTurn> RobotWorld::arrived()
{
  std::vector<simulation::LidarTurn> turns;
  const simulation::Motion driven = vehicle_.recent(kTurnReach_s);
  for (size_t i = 0; i < lidars_.size(); ++i)
  {
    uint64_t& next = next_turns_[i];
    const uint64_t over = lidars_[i].turnsUntil(t_s());
    for (; next < over && lidars_[i].arrivalOf(next) <= now(); ++next)
    {
      if (!lidars_[i].isLost(next))
      {
        turns.push_back(lidars_[i].turn(next, caster_, driven));
      }
    }
  }
  std::stable_sort(
      turns.begin(), turns.end(),
      [](const auto& a, const auto& b) { return a.arrival < b.arrival; });
  return turns;
}

double RobotWorld::clearance_m() const
{
  return surroundings_.clearance_m(state().pose, t_s(), kFarClearance_m);
}
}  // namespace traverse::app
