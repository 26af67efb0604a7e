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

  /** f(cell) for the cells of the extent whose middle it contains. */
  template <class F>
  void forEachMiddle(
      const geometry::Lattice& lattice, const geometry::CellRect& extent, const F& f) const
  {
    const geometry::CellRect near = cellsIn(lattice, extent);
    for (geometry::CellIndex c = near.min; c.y < near.max.y; ++c.y)
    {
      for (c.x = near.min.x; c.x < near.max.x; ++c.x)
      {
        if (containsMiddle(lattice, c))
        {
          f(c);
        }
      }
    }
  }

 private:
  /** The cells of the extent that it may contain. */
  geometry::CellRect cellsIn(
      const geometry::Lattice& lattice, const geometry::CellRect& extent) const;

  geometry::Outline corners_;
};
}  // namespace traverse::navigation
