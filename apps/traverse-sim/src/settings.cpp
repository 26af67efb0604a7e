// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "settings.h"

#include <traverse/config/ini_document.h>
#include <traverse/simulating/recording_file.h>

#include <fmt/format.h>
#include <stdexcept>

namespace traverse::app
{
namespace
{
/** TODO(sim-scenes): readScene(), generate(), buildScene(), sceneText(). */
class FlatTerrain : public simulation::Terrain
{
 public:
  simulation::GroundAt at(double /*x_m*/, double /*y_m*/) const override { return {}; }

  bool isSharpIn(const simulation::Area& /*area*/) const override { return false; }
};

/** Another section would silently do nothing. */
void checkSections(const config::IniDocument& ini)
{
  for (const config::Entry& entry : ini.entries())
  {
    if (!simulating::isOfRecording(entry.section))
    {
      throw config::ConfigError(
          fmt::format("{}: unknown section [{}]", entry.place, entry.section), entry.section);
    }
  }
}

void checkDrive(const SimSettings& settings)
{
  try
  {
    simulation::driveOn(
        *settings.scene.terrain, settings.recording.drive, settings.recording.vehicle);
  }
  catch (const std::invalid_argument& e)
  {
    throw config::ConfigError(fmt::format("[Drive], [Vehicle]: {}", e.what()), "Drive");
  }
}
}  // namespace

SimSettings readSettings(const SimCommand& command)
{
  auto ini = config::IniDocument::fromFile(command.scene);
  for (const std::string& assignment : command.assignments)
  {
    ini.set(assignment);
  }
  checkSections(ini);
  SimSettings settings;
  settings.scene.terrain = std::make_shared<FlatTerrain>();
  settings.recording = simulating::readRecording(ini);
  settings.text = simulating::recordingText(settings.recording);
  checkDrive(settings);
  return settings;
}
}  // namespace traverse::app
