// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smooth_line.h"

#include <traverse/geometry/vehicle.h>
#include <traverse/simulation/scene.h>

#include <vector>

namespace traverse::simulation
{
/** The plane that a vehicle stands on: height under its frame's origin, slopes forward and to the
 * left. */
struct WheelPlane
{
  double z_m = 0;
  double forward = 0;
  double left = 0;
};

/** The plane at every place of a line. */
std::vector<WheelPlane> wheelPlanes(
    const SmoothLine& line, const Terrain& terrain, const geometry::Vehicle& vehicle);
}  // namespace traverse::simulation
