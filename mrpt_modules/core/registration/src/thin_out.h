// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/points/scan.h>

#include <Eigen/Core>

#include <span>
#include <vector>

namespace traverse::registration
{
struct Thinning
{
  double voxel_m = 0;
  double max_range_m = 0;
};

/** The first point of each voxel, of those within range of the sensor; vehicle frame. */
std::vector<Eigen::Vector3d> thinOut(const points::Scan& scan, const Thinning& thinning);

/** Which points those are. */
std::vector<size_t> thinOutIndices(const points::Scan& scan, const Thinning& thinning);

/** The first point of each voxel. */
std::vector<Eigen::Vector3d> thinOut(std::span<const Eigen::Vector3d> points, double voxel_m);

/** See Params::voxel_m. */
double voxelFor(const points::Scan& scan, double max_range_m);
}  // namespace traverse::registration
