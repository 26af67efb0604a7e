// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/simulation/scene.h>
#include <traverse/simulation/scene_params.h>

#include <memory>

namespace traverse::simulation
{
/** The ground alone, [Scene] and all [Terrain_NN]. Throws as buildScene() does. */
std::shared_ptr<const Terrain> buildTerrain(const SceneParams& params);

/** The scene as surfaces: object i is [Object_i]. What [Random] asks for is not in it: see
 * generate(). Throws std::runtime_error that names section and key where the parameters make no
 * scene or a raster's file cannot be read. */
Scene buildScene(const SceneParams& params);
}  // namespace traverse::simulation
