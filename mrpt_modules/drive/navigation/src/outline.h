// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/lattice.h>
#include <traverse/geometry/outline.h>
#include <traverse/geometry/pose2.h>
#include <traverse/geometry/vehicle.h>

namespace traverse::navigation
{
/** The footprint of a vehicle that stands somewhere. */
class Outline
{
 public:
  /** Contains nothing where the pose is not finite or the footprint has less than three corners. */
  Outline(const geometry::Vehicle& vehicle, const geometry::Pose2& stand);

  bool containsMiddle(const geometry::Lattice& lattice, geometry::CellIndex c) const
  {
    return geometry::contains(corners_, {lattice.centre_m(c.x), lattice.centre_m(c.y)});
  }

  /** All of a cell, to its corners. */
  bool containsAll(const geometry::Lattice& lattice, geometry::CellIndex c) const;

  /** The cells of the extent that it may contain. */
  geometry::CellRect cellsIn(
      const geometry::Lattice& lattice, const geometry::CellRect& extent) const;

 private:
  geometry::Outline corners_;
};
}  // namespace traverse::navigation
