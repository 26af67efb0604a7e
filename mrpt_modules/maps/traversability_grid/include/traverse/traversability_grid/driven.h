// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/lattice.h>
#include <traverse/geometry/vehicle.h>
#include <traverse/ground/column.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace traverse::traversability_grid
{
/** The ground under the vehicle wherever a scan was taken, by its poses: the lowest and the highest
 * of a cell, in integers, so that any order and any repetition gives the same. From here the ground
 * estimate spreads. */
class DrivenCells
{
 public:
  /** Lowest and highest value met. */
  struct Range
  {
    int64_t low = std::numeric_limits<int64_t>::max();
    int64_t high = std::numeric_limits<int64_t>::min();

    void add(const Range& other)
    {
      low = std::min(low, other.low);
      high = std::max(high, other.high);
    }

    double middle() const { return (static_cast<double>(low) + static_cast<double>(high)) / 2; }

    friend bool operator==(const Range&, const Range&) = default;
  };

  struct Stand
  {
    Range z_mm;
    Range slope_x;  //!< metres up per metre, in kSlopeUnit
    Range slope_y;

    friend bool operator==(const Stand&, const Stand&) = default;
  };

  static constexpr double kSlopeUnit = 1e-4;

  /** Stands are kept by squares of 1 m, so that a yard driven over for days has no more of them. */
  static constexpr int32_t kStand_mm = 1000;

  /** By row, then column, of the lattice of stands. */
  using Map = std::map<std::pair<int32_t, int32_t>, Stand>;

  /** The vehicle stood at T_map_base; a pose too steep to drive on is left out. */
  void add(const Eigen::Isometry3d& T_map_base, const geometry::Vehicle& vehicle);

  void add(const std::pair<int32_t, int32_t>& row_column, const Stand& stand);

  void add(const DrivenCells& other);

  /** Forgets what lies outside. */
  void keep(const geometry::CellRect& window, const geometry::Lattice& lattice);

  void clear() { cells_.clear(); }

  /** Ground under the vehicle, in a window of cells; heights above reference_mm. Where it stood at
   * several heights, as in a garage, the lowest. */
  void seedsIn(
      const geometry::CellRect& window,
      const geometry::Lattice& lattice,
      int64_t reference_mm,
      std::vector<ground::Seed>& seeds) const;

  /** Height of the first stand in the window, or 0: a reference that depends on the stands only. */
  int64_t referenceIn(const geometry::CellRect& window, const geometry::Lattice& lattice) const;

  /** Whether the vehicle stood in the window. */
  bool anyIn(const geometry::CellRect& window, const geometry::Lattice& lattice) const;

  /** The smallest rectangle of cells with the stands of the window; empty where there is none. */
  geometry::CellRect boundsIn(
      const geometry::CellRect& window, const geometry::Lattice& lattice) const;

  const Map& cells() const { return cells_; }

 private:
  /** Calls f(x_mm, y_mm, const Stand&) with the stands' middles, row by row, until it returns
   * false; costs by the rows and stands of the window, not by the drive. */
  template <class F>
  void forEachIn(const geometry::CellRect& window, const geometry::Lattice& lattice, F&& f) const;

  Map cells_;
};
}  // namespace traverse::traversability_grid
