// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "settings.h"

#include <traverse/common_app/vehicle_check.h>
#include <traverse/config/strict.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace traverse::app
{
namespace
{
using config::ConfigError;
using config::sameName;

const std::vector<std::string>& ownSections()
{
  static const std::vector<std::string> kSections = {"traverse-map", "Vehicle", "Poses",
                                                     "Sensors",      "Log",     "Maps"};
  return kSections;
}

/** What no single key can say. */
void checkTogether(const Settings& settings)
{
  checkVehicle(settings.vehicle);
  if (settings.poses.source == poses::PoseSource::file && settings.poses.file.empty())
  {
    throw ConfigError("[Poses] source = file needs file = a trajectory");
  }
  const auto& origin = settings.poses.ins_origin;
  if (!origin.empty() &&
      (origin.size() != 3 || std::abs(origin[0]) > 90 || std::abs(origin[1]) > 360))
  {
    throw ConfigError(
        "[Poses] ins_origin needs three numbers: latitude and longitude in degrees, height in m");
  }
}

/** Labels within the output folder would be replaced with it; the output within theirs mixes with
 * them. */
void checkLabelFolder(const Settings& settings)
{
  if (settings.point_labels.empty() || settings.output.empty())
  {
    return;
  }
  const auto plain = [](const std::filesystem::path& p)
  { return std::filesystem::weakly_canonical(std::filesystem::absolute(p)); };
  const auto lies_in = [](const std::filesystem::path& inner, const std::filesystem::path& outer)
  {
    return std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end()).first ==
           outer.end();
  };
  const std::filesystem::path labels = plain(settings.point_labels);
  const std::filesystem::path output = plain(settings.output);
  if (lies_in(labels, output) || lies_in(output, labels) ||
      lies_in(labels, output.string() + ".partial"))
  {
    throw ConfigError(
        "--point-labels needs a folder beside the output folder, not within or around it");
  }
}
}  // namespace

Settings loadSettings(const Command& command)
{
  Settings settings;
  settings.ini = config::IniDocument::fromFile(command.config, command.assignments);
  config::load(settings.ini, "traverse-map", settings.run);
  config::load(settings.ini, "Vehicle", settings.vehicle);
  config::load(settings.ini, "Poses", settings.poses);
  config::load(settings.ini, "Sensors", settings.sensors);
  config::load(settings.ini, "Log", settings.log);
  settings.poses.file = settings.ini.pathOf("Poses", "file", settings.poses.file);
  settings.poses.times_file = settings.ini.pathOf("Poses", "times_file", settings.poses.times_file);
  checkTogether(settings);

  MapWishes wishes = readWantedMaps(settings.ini);
  checkSections(settings.ini, ownSections(), wishes);
  settings.maps = wishes.ours;
  settings.warnings = wishes.warnings;
  settings.rawlog = command.rawlog.empty()
                        ? settings.ini.pathOf("traverse-map", "rawlog", settings.run.rawlog)
                        : command.rawlog;
  settings.rebuild = command.rebuild;
  settings.rawlog = command.rebuild.empty() ? settings.rawlog : settings.rebuild;
  settings.output = command.output.empty() ? settings.run.output : command.output;
  settings.point_labels = command.point_labels;
  checkLabelFolder(settings);
  settings.piece = command.piece;
  settings.force = command.force;
  settings.quiet = command.quiet;
  return settings;
}
}  // namespace traverse::app
