// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

  /** The neighbourhood's part of the map's extent. */
  const geometry::CellRect& accepted() const { return accepted_; }

  /** Steps 1 and 2 for the scan's next points from `first`, up to LatticePoints::kMost of them;
   * rows and columns from accepted().min. Those that are not in there are counted in `stats`. */
  void project(
      const points::Scan& scan,
      size_t first,
      LatticePoints& points,
      layers::UpdateStats& stats) const;

 private:
  Projection(const Eigen::Isometry3d& T_map_base, const State& state, const Params& params);

  geometry::CellRect neighbourhood_;
  geometry::CellRect accepted_;
  LatticeBox box_;
};
}  // namespace traverse::traversability_grid
