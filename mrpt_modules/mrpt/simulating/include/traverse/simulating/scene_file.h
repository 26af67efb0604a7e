// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/config/ini_document.h>
#include <traverse/simulation/scene.h>
#include <traverse/simulation/scene_params.h>

#include <string>

namespace traverse::simulating
{
/** The sections [Scene], [Terrain_NN], [Object_NN], [Random] and [Mission] of a scene file, and the
 * corners of [Drive]; NN counts from 00 without gaps. Other sections are left alone. Throws
 * ConfigError with place, section and key for a section that only begins like one of these, a gap,
 * an unknown key or a value that is not allowed. */
simulation::SceneParams readScene(const config::IniDocument& ini);

/** The scene as an ini text from which readScene() reads the same scene, its folder excepted. Keys
 * with their default are left out. Throws ConfigError where a text cannot stand in an ini file. */
std::string sceneText(const simulation::SceneParams& scene);

/** Throws ConfigError for a ground that memory does not hold. */
void checkGround(const simulation::Scene& scene);
}  // namespace traverse::simulating
