// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/config/ini_document.h>
#include <traverse/nav_app/closed_loop.h>
#include <traverse/simulating/scene_file.h>
#include <traverse/simulation/build.h>

#include <fmt/format.h>

namespace traverse::app
{
namespace
{
using config::ConfigError;

std::vector<navigation::Goal> goalsOf(
    const NavSettings& settings, const simulation::SceneParams& scene)
{
  std::vector<navigation::Goal> goals;
  for (size_t i = 0; i < settings.run.goal_xs_m.size(); ++i)
  {
    goals.push_back({settings.run.goal_xs_m[i], settings.run.goal_ys_m[i], std::nullopt});
  }
  if (goals.empty())
  {
    for (const geometry::Pose2& goal : simulation::goalsOf(scene.mission))
    {
      goals.push_back({goal.x_m, goal.y_m, std::nullopt});
    }
  }
  if (goals.empty())
  {
    throw ConfigError(fmt::format(
        "{} proposes no mission: say goal_xs_m and goal_ys_m in [traverse-nav]",
        settings.scene.string()));
  }
  return goals;
}
}  // namespace

Mission readMission(const NavSettings& settings, uint64_t seed)
{
  if (settings.scene.empty())
  {
    throw ConfigError("[traverse-nav] scene: say which world to drive in");
  }
  const auto ini = config::IniDocument::fromFile(settings.scene);
  const simulation::SceneParams fixed = simulating::readScene(ini);
  try
  {
    const simulation::SceneParams scene = simulation::generate(fixed, seed);
    Mission mission{
        simulation::buildScene(scene), simulation::startOf(scene.mission),
        goalsOf(settings, scene)};
    simulating::checkGround(mission.scene);
    return mission;
  }
  catch (const ConfigError&)
  {
    throw;
  }
  catch (const std::exception& e)
  {
    throw ConfigError(fmt::format("{}: {}", settings.scene.string(), e.what()));
  }
}
}  // namespace traverse::app
