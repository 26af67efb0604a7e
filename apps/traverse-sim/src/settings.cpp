// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "settings.h"

#include <traverse/config/ini_document.h>
#include <traverse/formats/checksum.h>
#include <traverse/simulating/recording_file.h>
#include <traverse/simulating/scene_file.h>
#include <traverse/simulation/build.h>
#include <traverse/simulation/ray_caster.h>
#include <traverse/simulation/truth.h>

#include <algorithm>
#include <array>
#include <exception>
#include <filesystem>
#include <fmt/format.h>

namespace traverse::app
{
namespace
{
/** What `make` returns; what it refuses is a fault of the ini. */
template <class F>
auto asConfiguration(const F& make)
{
  try
  {
    return make();
  }
  catch (const std::exception& e)
  {
    throw config::ConfigError(e.what());
  }
}

/** Those that readScene() reads or refuses. */
bool isOfScene(std::string_view section)
{
  constexpr std::array<std::string_view, 5> kBegins = {
      "Scene", "Random", "Terrain", "Object", "Mission"};
  return std::any_of(
      kBegins.begin(), kBegins.end(),
      [&](std::string_view begin)
      { return config::sameName(section.substr(0, begin.size()), begin); });
}

/** Another section would silently do nothing. */
void checkSections(const config::IniDocument& ini)
{
  for (const config::Entry& entry : ini.entries())
  {
    if (!simulating::isOfRecording(entry.section) && !isOfScene(entry.section) &&
        !config::sameName(entry.section, "Truth"))
    {
      throw config::ConfigError(
          fmt::format("{}: unknown section [{}]", entry.place, entry.section), entry.section);
    }
  }
}

/** What there is, with what [Random] asks for; files by absolute names, so that its ini can be used
 * from anywhere. */
simulation::SceneParams sceneOf(const config::IniDocument& ini, uint64_t seed)
{
  const simulation::SceneParams fixed = simulating::readScene(ini);
  simulation::SceneParams scene =
      asConfiguration([&] { return simulation::generate(fixed, seed); });
  for (simulation::TerrainParams& terrain : scene.terrains)
  {
    for (std::string* file : {&terrain.file, &terrain.transform_file})
    {
      *file = file->empty() ? "" : std::filesystem::absolute(scene.folder / *file).string();
    }
  }
  return scene;
}

/** Size and CRC-32 of each raster's files, so that parts made of others are not used. */
std::string filesOf(const simulation::SceneParams& scene)
{
  std::string all;
  for (const simulation::TerrainParams& terrain : scene.terrains)
  {
    for (const std::string& file : {terrain.file, terrain.transform_file})
    {
      std::error_code error;
      if (std::filesystem::is_regular_file(file, error))
      {
        all += fmt::format(
            "// {}: {} bytes, CRC-32 {:08x}\n", file, std::filesystem::file_size(file),
            formats::crc32OfFile(file));
      }
    }
  }
  return all;
}

/** A number of an object has 16 bits in the labels. */
void checkObjects(const simulation::Scene& scene)
{
  constexpr size_t kMost = 65536 - simulation::Scene::kFirstObject;
  if (scene.objects.size() > kMost)
  {
    throw config::ConfigError(
        fmt::format("{} objects: a scene may have {}", scene.objects.size(), kMost));
  }
}

simulation::Motion checkedDrive(const SimSettings& settings)
{
  return asConfiguration(
      [&]
      {
        return simulation::driveOn(
            *settings.scene.terrain, settings.recording.drive, settings.recording.vehicle);
      });
}

/** What writing the truth would refuse in the end. */
void checkTruth(const SimSettings& settings, const simulation::Motion& drive)
{
  const std::vector<double>& at_s = settings.truth.at_s;
  const double end_s = drive.poses().back().t_s;
  if (!at_s.empty() && at_s.back() > end_s)
  {
    throw config::ConfigError(
        fmt::format(
            "[Truth] at_s = '{}': allowed: up to the end of the recording, {} s",
            options::format(at_s), end_s),
        "Truth", "at_s");
  }
  asConfiguration(
      [&]
      {
        simulation::checkTruth(
            settings.scene, settings.truth.cells, drive.at(0).translation().head<2>());
      });
}
}  // namespace

SimSettings readSettings(const SimCommand& command)
{
  const auto ini = config::IniDocument::fromFile(command.ini, command.assignments);
  checkSections(ini);
  SimSettings settings;
  settings.recording = simulating::readRecording(ini);
  settings.truth = simulating::readTruthSection(ini);
  simulation::SceneParams scene = sceneOf(ini, command.seed);
  if (ini.find("Drive", "xs_m") == nullptr && !scene.drive_xs_m.empty())
  {
    settings.recording.drive.xs_m = scene.drive_xs_m;
    settings.recording.drive.ys_m = scene.drive_ys_m;
  }
  settings.scene = asConfiguration([&] { return simulation::buildScene(scene); });
  settings.files = asConfiguration([&] { return filesOf(scene); });
  checkObjects(settings.scene);
  simulating::checkGround(settings.scene);
  scene.drive_xs_m.clear();  // the recording says them
  scene.drive_ys_m.clear();
  settings.text = simulating::sceneText(scene) + simulating::recordingText(settings.recording) +
                  simulating::truthText(settings.truth);
  checkTruth(settings, checkedDrive(settings));
  return settings;
}
}  // namespace traverse::app
