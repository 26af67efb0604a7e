// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/outline.h>
#include <traverse/geometry/vehicle.h>
#include <traverse/layers/layer_set.h>
#include <traverse/simulation/scene.h>
#include <traverse/simulation/truth.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace traverse::simulation
{
/** A convex polygon of the map frame, m, counter-clockwise, the first corner not repeated. */
using geometry::Outline;

/** Where a thing stands on the ground. */
struct Footprint
{
  uint32_t object = Scene::kNoObject;  //!< its number
  std::string name;
  Label label = Label::thing;
  double height_m = 0;            //!< of its top over the ground, at most the vehicle's height
  std::vector<Outline> outlines;  //!< one around each piece, without those within another
};

/** Footprints of the things at at_s: of what is hard, and stands above the ground and lower than
 * the vehicle's height over it. Things without any are left out. The same bits on every machine.
 * Throws std::invalid_argument for a scene without ground or a triangle of vertices that are not
 * there. */
std::vector<Footprint> footprints(
    const Scene& scene, const geometry::Vehicle& vehicle, double at_s);

/** Layer truth_swept on the cells of cellTruth(): 1 where a moving thing was above at any time of
 * [from_s, to_s], to half a cell. Throws as cellTruth(). */
layers::LayerSet sweptCells(
    const Scene& scene, const TruthParams& params, double from_s, double to_s);
}  // namespace traverse::simulation
