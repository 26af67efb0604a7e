// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/simulation/scene.h>

#include <Eigen/Core>

#include <vector>

// Closed meshes of few triangles; corners run counter-clockwise seen from outside.
namespace traverse::simulation
{
/** A box with sides along the axes. */
Part boxPart(const Eigen::Vector3d& low, const Eigen::Vector3d& high, Material material);

/** An upright prism; outline without crossings, in either direction, three corners or more. */
Part prismPart(
    const std::vector<Eigen::Vector2d>& outline, double bottom_m, double top_m, Material material);

/** A round bar with flat ends and `sides` sides, thinner or thicker towards its end. */
struct Bar
{
  Eigen::Vector3d from = Eigen::Vector3d::Zero();
  Eigen::Vector3d to = Eigen::Vector3d::UnitZ();
  double from_radius_m = 0.1;
  double to_radius_m = 0.1;
  int sides = 8;
};

Part barPart(const Bar& bar, Material material);

/** A piece of a wall or a board: a box from a to b (both on its lower edge), which need not be
 * level, of that thickness and height. */
struct Slab
{
  Eigen::Vector3d a = Eigen::Vector3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::UnitX();
  double thickness_m = 0.1;
  double height_m = 1;
};

Part slabPart(const Slab& slab, Material material);

/** Two ring of corners, the lower and the upper one, joined by sides and closed by flat ends. */
Part loftPart(
    const std::vector<Eigen::Vector3d>& lower,
    const std::vector<Eigen::Vector3d>& upper,
    Material material);

/** One loose triangle more. */
void addSheet(
    Part& part, const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

/** Turned about z and moved. */
void place(Part& part, double yaw_rad, const Eigen::Vector3d& to);

/** True for an outline whose edges do not cross and whose area is not 0. */
bool isSimple(const std::vector<Eigen::Vector2d>& outline);
}  // namespace traverse::simulation
