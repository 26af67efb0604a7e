// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/registration/local_map.h>

#include <Eigen/Geometry>

#include <span>

namespace traverse::registration
{
/** Which points are pairs, and how much far ones count. */
struct Gate
{
  double reach_m = 1;    //!< pairs further apart are none
  double kernel_m = 1;   //!< scale of the Geman-McClure kernel
  double close_m = 0.1;  //!< a point nearer to its plane than this lies on it
};

/** What align() found. */
struct Alignment
{
  Eigen::Isometry3d T_map_base = Eigen::Isometry3d::Identity();
  size_t matched = 0;  //!< points with a surface within reach, in the last iteration
  int iterations = 0;
  size_t close = 0;      //!< of those, points that lie on their plane
  double last_step = 0;  //!< m and rad together; pairs that come and go may keep it from 0
  /** The least that one of the six directions of motion is held by, as a share of the pairs (each
   * weighs at most 1; rotations at the points' root mean square distance). */
  double constraint = 0;
};

/** Moves points of the vehicle frame onto the map, from a first guess: Gauss-Newton over the
 * distances to the planes at the nearest points of the map, with a robust kernel. */
Alignment align(
    std::span<const Eigen::Vector3d> points,
    LocalMap& map,
    const Eigen::Isometry3d& T_map_guess,
    const Gate& gate);
}  // namespace traverse::registration
