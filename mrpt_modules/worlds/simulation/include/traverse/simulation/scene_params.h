// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/simulation/mission_params.h>
#include <traverse/simulation/object_params.h>
#include <traverse/simulation/random_scene_params.h>
#include <traverse/simulation/scene_extent.h>
#include <traverse/simulation/terrain_params.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace traverse::simulation
{
/** A scene in words: what its ini file says. */
struct SceneParams
{
  SceneExtentParams extent;             //!< [Scene]
  std::vector<TerrainParams> terrains;  //!< [Terrain_00], [Terrain_01], ...
  std::vector<ObjectParams> objects;    //!< [Object_00], [Object_01], ...
  RandomSceneParams random;             //!< [Random]
  std::vector<double> drive_xs_m;       //!< the way that generate() proposes: [Drive] xs_m
  std::vector<double> drive_ys_m;       //!< [Drive] ys_m
  MissionParams mission;                //!< [Mission]; of styles for navigators generate() says it
  std::filesystem::path folder;         //!< relative file names are relative to it

  friend bool operator==(const SceneParams&, const SceneParams&) = default;
};

/** "Terrain_07", "Object_123": the section of a piece. */
std::string numberedSection(const std::string& prefix, size_t index);

/** The fixed scene with what its [Random] asks for: an explicit scene with a way to drive along,
 * whose own style is none. The same seed gives the same scene on every machine. With style none it
 * is the fixed scene. Throws std::runtime_error where the area is too small. */
SceneParams generate(const SceneParams& fixed, uint64_t seed);
}  // namespace traverse::simulation
