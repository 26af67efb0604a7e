// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smooth_line.h"

#include <traverse/geometry/vehicle.h>
#include <traverse/simulation/scene.h>

#include <Eigen/Geometry>

#include <array>
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

/** Where the wheels are: at the corners of the box round the footprint, in the vehicle frame. */
struct Wheels
{
  double front_m, rear_m, left_m, right_m;

  /** Throws std::invalid_argument where the footprint has no length or no width. */
  explicit Wheels(const geometry::Vehicle& vehicle);

  /** Front left, front right, rear left, rear right. */
  std::array<Eigen::Vector2d, 4> corners() const
  {
    return {
        Eigen::Vector2d(front_m, left_m), Eigen::Vector2d(front_m, right_m),
        Eigen::Vector2d(rear_m, left_m), Eigen::Vector2d(rear_m, right_m)};
  }

  /** A place of the vehicle frame on the map. */
  static Eigen::Vector2d onMap(const SmoothLine::Place& place, const Eigen::Vector2d& p_vehicle);

  /** Of the ground under the corners. */
  std::array<double, 4> heights(const Terrain& terrain, const SmoothLine::Place& place) const;

  /** The plane through four heights. */
  WheelPlane planeOf(const std::array<double, 4>& z_m) const;
};

/** The plane at every place of a line. */
std::vector<WheelPlane> wheelPlanes(
    const SmoothLine& line, const Terrain& terrain, const geometry::Vehicle& vehicle);

/** T_map_base on a plane: x along the heading, z at right angles to the plane. */
Eigen::Isometry3d standing(
    const SmoothLine::Place& place, const WheelPlane& plane, double base_height_m);
}  // namespace traverse::simulation
