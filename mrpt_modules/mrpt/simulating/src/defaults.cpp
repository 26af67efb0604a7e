// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/options/ini_text.h>
#include <traverse/simulating/defaults.h>
#include <traverse/simulating/recording_file.h>
#include <traverse/simulating/truth_section.h>
#include <traverse/simulation/scene_params.h>

#include <string_view>

namespace traverse::simulating
{
namespace
{
template <class P>
std::string section(std::string_view meaning, std::string_view name, const P& params)
{
  return options::commentedSection(meaning, name, options::rows(params));
}
}  // namespace

std::string defaultsText()
{
  const simulation::RecordingParams recording;
  return "// Every section and key of a scene file with its default. doc/simulation.md says "
         "more.\n" +
         section("What there is: the ground's extent.", "Scene", simulation::SceneExtentParams()) +
         section(
             "A piece of ground; more as [Terrain_01] ...",
             simulation::numberedSection("Terrain_", 0), simulation::TerrainParams()) +
         section(
             "A thing on it; more as [Object_01] ...", simulation::numberedSection("Object_", 0),
             simulation::ObjectParams()) +
         section("What the seed adds.", "Random", simulation::RandomSceneParams()) +
         section("Where a navigator is to go.", "Mission", simulation::MissionParams()) +
         section("What drives.", "Vehicle", recording.vehicle) +
         section("Where it drives.", "Drive", recording.drive) +
         section(
             "A lidar; more as [Lidar_01] ...", simulation::numberedSection("Lidar_", 0),
             recording.lidars.front()) +
         section("Poses.", "Ins", recording.ins) +
         section("Poses that drift.", "Odometry", recording.odometry) +
         section("The truth about places.", "Truth", TruthSection());
}
}  // namespace traverse::simulating
