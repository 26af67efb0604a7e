// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/lattice.h>
#include <traverse/geometry/vehicle.h>
#include <traverse/ground/column.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace traverse::traversability_grid
{
/** The ground under the vehicle wherever a scan was taken, by its poses: sums of integers, so that
 * any order of the scans gives the same. From here the ground estimate spreads. */
class DrivenCells
{
 public:
  struct Sums
  {
    uint64_t n = 0;
    int64_t z_mm = 0;
    int64_t slope_x = 0;  //!< metres up per metre, in kSlopeUnit
    int64_t slope_y = 0;

    friend bool operator==(const Sums&, const Sums&) = default;
  };

  static constexpr double kSlopeUnit = 1e-4;

  /** A cell counts no more (46 days of standing at 10 Hz): its sums cannot overflow. */
  static constexpr uint64_t kMostStands = 40'000'000;

  /** By row, then column. */
  using Map = std::map<std::pair<int32_t, int32_t>, Sums>;

  /** The vehicle stood at T_map_base; a pose too steep to drive on is left out. */
  void add(
      const Eigen::Isometry3d& T_map_base,
      const geometry::Vehicle& vehicle,
      const geometry::Lattice& lattice);

  void add(const DrivenCells& other);

  /** Forgets what lies outside. */
  void keep(const geometry::CellRect& window);

  void clear() { cells_.clear(); }

  /** Ground under the vehicle, in a window; heights above reference_mm. */
  void seedsIn(
      const geometry::CellRect& window,
      const geometry::Lattice& lattice,
      int64_t reference_mm,
      std::vector<ground::Seed>& seeds) const;

  /** Height of the first driven cell in the window, or 0: a reference that depends on the driven
   * cells only. */
  int64_t referenceIn(const geometry::CellRect& window) const;

  const Map& cells() const { return cells_; }

  Map& cells() { return cells_; }

 private:
  Map cells_;
};
}  // namespace traverse::traversability_grid
