// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/common_app/vehicle_check.h>
#include <traverse/config/strict.h>
#include <traverse/nav_app/settings.h>
#include <traverse/simulating/recording_file.h>
#include <traverse/simulation/scene_params.h>

namespace traverse::app
{
namespace
{
using config::ConfigError;

/** [Lidar_NN] as many as there are; [Drive] and [Ins] would do nothing. */
std::vector<std::string> ownSections(const NavSettings& settings)
{
  std::vector<std::string> own = {"traverse-nav", "Vehicle", "Drivetrain", "Odometry",  "Costmap",
                                  "Planner",      "Speed",   "Guard",      "Watchdogs", "Reactive",
                                  "Poses",        "Sensors", "Log",        "Maps"};
  for (size_t i = 0; i < settings.robot.lidars.size(); ++i)
  {
    own.push_back(simulation::numberedSection("Lidar_", i));
  }
  return own;
}

/** What no single key can say. */
void checkTogether(const NavSettings& settings)
{
  checkVehicle(settings.robot.vehicle);
  if (settings.run.goal_xs_m.size() != settings.run.goal_ys_m.size())
  {
    throw ConfigError("[traverse-nav] goal_xs_m and goal_ys_m need as many numbers");
  }
}
}  // namespace

NavSettings readNavSettings(
    const std::filesystem::path& file, const std::vector<std::string>& assignments)
{
  NavSettings settings;
  settings.ini = config::IniDocument::fromFile(file, assignments);
  config::load(settings.ini, "traverse-nav", settings.run);
  config::load(settings.ini, "Drivetrain", settings.drivetrain);
  config::load(settings.ini, "Costmap", settings.costs);
  config::load(settings.ini, "Planner", settings.plan);
  config::load(settings.ini, "Speed", settings.speed);
  config::load(settings.ini, "Guard", settings.guard);
  config::load(settings.ini, "Watchdogs", settings.watchdogs);
  config::load(settings.ini, "Reactive", settings.reactive);
  config::load(settings.ini, "Poses", settings.poses);
  config::load(settings.ini, "Sensors", settings.sensors);
  config::load(settings.ini, "Log", settings.log);
  settings.poses.file = settings.ini.pathOf("Poses", "file", settings.poses.file);
  settings.poses.times_file = settings.ini.pathOf("Poses", "times_file", settings.poses.times_file);
  settings.robot = simulating::readRecording(settings.ini);
  MapWishes wishes = readWantedMaps(settings.ini);
  checkSections(settings.ini, ownSections(settings), wishes);
  settings.maps = wishes.ours;
  settings.warnings = wishes.warnings;
  checkTogether(settings);
  const std::filesystem::path scene = settings.run.scene;
  settings.scene = scene.is_relative() && !scene.empty() ? settings.ini.folder() / scene : scene;
  return settings;
}
}  // namespace traverse::app
