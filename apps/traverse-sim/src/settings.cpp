// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "settings.h"

#include <traverse/config/ini_document.h>
#include <traverse/simulating/recording_file.h>

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
}  // namespace

SimSettings readSettings(const SimCommand& command)
{
  auto ini = config::IniDocument::fromFile(command.scene);
  for (const std::string& assignment : command.assignments)
  {
    ini.set(assignment);
  }
  SimSettings settings;
  settings.scene.terrain = std::make_shared<FlatTerrain>();
  settings.recording = simulating::readRecording(ini);
  settings.text = simulating::recordingText(settings.recording);
  return settings;
}
}  // namespace traverse::app
