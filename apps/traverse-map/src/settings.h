// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "command_line.h"
#include "run_params.h"

#include <traverse/common_app/wanted_maps.h>
#include <traverse/config/ini_document.h>
#include <traverse/geometry/vehicle.h>
#include <traverse/logs/log_params.h>
#include <traverse/observations/observation_params.h>
#include <traverse/plugin/schemas.h>
#include <traverse/poses/pose_source.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace traverse::app
{
/** Everything a run needs, checked. */
struct Settings
{
  config::IniDocument ini;
  RunParams run;
  geometry::Vehicle vehicle;
  poses::PoseParams poses;
  observations::ObservationParams sensors;
  logs::LogParams log;
  std::vector<WantedMap> maps;
  std::vector<std::string> warnings;
  std::filesystem::path rawlog;
  std::filesystem::path rebuild;  //!< the octree to map instead of the log; empty: the log
  std::filesystem::path output;
  std::filesystem::path point_labels;  //!< empty: none
  std::optional<Piece> piece;
  bool force = false;
  bool quiet = false;
};

/** Reads and checks the ini, `--set` and the other overrides applied. Throws config::ConfigError
 * with file:line. Sections of stock MRPT maps are left to MRPT, with a warning. */
Settings loadSettings(const Command& command);

/** The run's own ini, complete: own sections with every key, the maps' with what was given. Another
 * run with it, from any folder, makes the same maps. */
std::string configIni(const Settings& settings);

/** "[section] key" and value of all that maps depend on besides the log, the poses and the maps'
 * own options. */
std::vector<std::pair<std::string, std::string>> recipe(const Settings& settings);

/** An ini with every key of the app and of every map at its default. */
std::string defaultsIni();

/** The same as Markdown tables with type, allowed values and meaning. */
std::string optionTables();
}  // namespace traverse::app
