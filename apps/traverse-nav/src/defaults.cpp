// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "defaults.h"

#include <traverse/nav_app/settings.h>
#include <traverse/options/ini_text.h>

#include <string_view>

namespace traverse::app
{
namespace
{
template <class P>
std::string section(std::string_view meaning, std::string_view name, const P& params)
{
  return options::commentedSection(meaning, name, options::rows(params));
}
}  // namespace

std::string navDefaultsText()
{
  const NavSettings settings;
  return "// Every section and key of traverse-nav with its default. Sections of maps: "
         "ini/reference.ini. doc/navigation.md says more.\n" +
         section("The run.", "traverse-nav", settings.run) +
         section("What drives.", "Vehicle", settings.robot.vehicle) +
         section("What it can do.", "Drivetrain", settings.drivetrain) +
         section("A lidar; more as [Lidar_01] ...", "Lidar_00", settings.robot.lidars.front()) +
         section("Poses that drift (poses = icp_3d).", "Odometry", settings.robot.odometry) +
         section("What the planner makes of the maps.", "Costmap", settings.costs) +
         section("How a way is sought.", "Planner", settings.plan) +
         section("How fast it is driven.", "Speed", settings.speed) +
         section("MRPT's reactive navigator.", "Reactive", settings.reactive) +
         section("What the last command is held against.", "Guard", settings.guard) +
         section("When the vehicle stops.", "Watchdogs", settings.watchdogs) +
         section("Replay: where poses come from.", "Poses", settings.poses) +
         section("Replay: how the log's observations are read.", "Sensors", settings.sensors) +
         section("Replay: what reading the log may use.", "Log", settings.log);
}
}  // namespace traverse::app
