// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/common_app/wanted_maps.h>
#include <traverse/config/ini_document.h>
#include <traverse/geometry/drivetrain.h>
#include <traverse/logs/log_params.h>
#include <traverse/nav_app/run_params.h>
#include <traverse/navigation/cost_params.h>
#include <traverse/navigation/motion_guard.h>
#include <traverse/navigation/plan_params.h>
#include <traverse/navigation/speed_profile.h>
#include <traverse/navigation/supervisor.h>
#include <traverse/observations/observation_params.h>
#include <traverse/poses/pose_source.h>
#include <traverse/reactive/reactive_driver.h>
#include <traverse/simulation/recording.h>

#include <filesystem>
#include <string>
#include <vector>

namespace traverse::app
{
/** All that the navigator does by an ini. */
struct NavSettings
{
  config::IniDocument ini;
  NavParams run;
  simulation::RecordingParams robot;  //!< [Vehicle], [Lidar_NN], [Odometry]; [Drive], [Ins] unused
  geometry::Drivetrain drivetrain;
  navigation::CostParams costs;
  navigation::PlanParams plan;
  navigation::SpeedParams speed;
  navigation::GuardParams guard;
  navigation::WatchdogParams watchdogs;
  reactive::ReactiveParams reactive;
  poses::PoseParams poses;  //!< of replays, like the next two
  observations::ObservationParams sensors;
  logs::LogParams log;
  std::vector<WantedMap> maps;
  std::vector<std::string> warnings;
  std::filesystem::path scene;  //!< from the working folder; empty: there is none
};

/** Reads and checks an ini with `assignments` ("section.key=value") over it. Throws
 * config::ConfigError with file:line. */
NavSettings readNavSettings(
    const std::filesystem::path& file, const std::vector<std::string>& assignments);
}  // namespace traverse::app
