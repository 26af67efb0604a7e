// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/floor_divider.h>
#include <traverse/layers/scan_consumer.h>
#include <traverse/traversability_grid/state.h>

#include <Eigen/Geometry>

#include <optional>

namespace traverse::traversability_grid
{
/** The robot's neighbourhood on the lattice, and the way from points of the vehicle frame to it. */
class Projection
{
 public:
  /** Nothing where the pose is not finite, no rigid motion, or too far out for the lattice. */
  static std::optional<Projection> at(
      const Eigen::Isometry3d& T_map_base, const State& state, const Params& params);

  /** The square of cells around the robot. */
  const geometry::CellRect& neighbourhood() const { return neighbourhood_; }

  /** Steps 1 and 2: those of the scan's points that lie in the neighbourhood, quantised to 1 mm in
   * the map frame after a transformation in double precision. The rest is counted in `stats`. */
  void project(
      const points::Scan& scan,
      std::vector<LatticePoint>& projected,
      layers::UpdateStats& stats) const;

  /** One point, if it is in the neighbourhood; counted where it is not. */
  std::optional<LatticePoint> project(
      const Eigen::Vector3f& p_base, layers::UpdateStats& stats) const;

 private:
  Projection(const Eigen::Isometry3d& T_map_base, const State& state, const Params& params);

  Eigen::Isometry3d T_map_base_;
  geometry::CellRect neighbourhood_;
  geometry::CellRect accepted_;  // the neighbourhood's part of the map's extent
  geometry::FloorDivider by_cell_;
  geometry::FloorDivider by_slab_;
  double lowest_m_;
  double highest_m_;
};
}  // namespace traverse::traversability_grid
