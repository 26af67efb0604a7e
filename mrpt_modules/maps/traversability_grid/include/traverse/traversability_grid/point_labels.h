// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/points/scan.h>
#include <traverse/traversability_grid/state.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <vector>

namespace traverse::traversability_grid
{
/** Codes of label files: a contract with everybody who reads them. */
enum class PointLabel : uint32_t
{
  undefined = 0,
  ground = 1,
  obstacle = 2,
  overhanging = 3,  //!< the vehicle fits under it
};

/** What the points of the scan that update() took last are, in their order, from their cells and
 * their heights over the ground. With classifier = paper, which knows no ground, points of flat and
 * slightly rough cells are ground. All undefined of a scan that was refused. */
std::vector<PointLabel> labelsOfLastScan(
    const State& state,
    const points::Scan& scan,
    const Eigen::Isometry3d& T_map_base,
    const Params& params);
}  // namespace traverse::traversability_grid
