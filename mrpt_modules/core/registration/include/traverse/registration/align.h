// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/registration/local_map.h>

#include <Eigen/Geometry>

#include <span>

namespace traverse::registration
{
/** Over a shift in the map frame (first three, m) and a turn about the vehicle's place, its axis in
 * the map frame (rad). */
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/** Which points are pairs, and how much far ones count. */
struct Gate
{
  double reach_m = 1;        //!< pairs further apart are none
  double kernel_m = 1;       //!< scale of the Geman-McClure kernel
  double close_m = 0.1;      //!< a point nearer to its plane than this lies on it
  double point_share = 0.1;  //!< of a plane's weight, for what lies on none and pulls as a point
  double settled = 1e-4;     //!< a smaller step (m and rad together) is the last; the paper's
  int most_iterations = 50;
};

/** What is known of the pose before it is matched: the inverse of the guess' covariance times the
 * variance of one pair's distance, so in units of pairs. None: all zero. */
struct Prior
{
  Matrix6 information = Matrix6::Zero();
};

/** What align() found. */
struct Alignment
{
  Eigen::Isometry3d T_map_base = Eigen::Isometry3d::Identity();
  size_t matched = 0;  //!< points with a surface within reach, in the last iteration
  int iterations = 0;
  size_t close = 0;   //!< of those, points that lie on their plane
  double planes = 0;  //!< sum of the pairs' Surface::weight
  double fit =
      0;  //!< the share of `planes` that the kernel leaves: 1 where all points lie on theirs
  double last_step = 0;  //!< m and rad together; pairs that come and go may keep it from 0
  /** The least that one of the six directions of motion is held by, as a share of the pairs (each
   * weighs at most 1; rotations at the points' root mean square distance). */
  double constraint = 0;
  Matrix6 information = Matrix6::Zero();  //!< the pairs', in units of pairs; without the prior
};

/** Moves points of the vehicle frame onto the map, from a first guess: Gauss-Newton over the
 * distances to the planes at the nearest points of the map, with a robust kernel, and over the
 * distance from the guess as far as the prior knows it. */
Alignment align(
    std::span<const Eigen::Vector3d> points,
    LocalMap& map,
    const Eigen::Isometry3d& T_map_guess,
    const Gate& gate,
    const Prior& prior = {});

/** The step from one pose to another, as align() makes them; for turns of less than a right angle.
 */
Vector6 stepBetween(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to);
}  // namespace traverse::registration
