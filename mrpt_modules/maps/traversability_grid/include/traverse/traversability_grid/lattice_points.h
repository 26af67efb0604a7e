// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

// No Eigen in here: see geometry/clones.h.
namespace traverse::traversability_grid
{
/** A rigid motion and a box of lattice cells, as plain numbers. */
struct LatticeBox
{
  std::array<std::array<double, 4>, 3> T_map_base{};  //!< rows of rotation and translation, metres
  int32_t cell_mm = 200;
  int32_t slab_mm = 500;
  double min_x_mm = 0, min_y_mm = 0;   //!< smallest corner, on the cells' edges
  double width_mm = 0, height_mm = 0;  //!< below 2^30; none or negative: nothing is inside
  double lowest_m = 0, highest_m = 0;  //!< heights that are inside
  int32_t bottom_level = 0;            //!< of the lowest slab, and its bottom
  double bottom_mm = 0;
  double depth_mm = 0;  //!< below 2^30; all heights inside are in [bottom_mm, bottom_mm + depth_mm)
};

/** Points on the map's lattice, in their scan's order; arrays by member, for vector instructions.
 */
struct LatticePoints
{
  static constexpr size_t kMost = 512;
  using Numbers = std::array<int32_t, kMost>;

  size_t size = 0;
  Numbers column{}, row{};  //!< of the cell, from the box's smallest corner; column -1: skipped
  Numbers level{};          //!< of the height slab; absolute
  Numbers x_mm{}, y_mm{}, z_mm{};  //!< from the cell's smallest corner and the slab's bottom
  uint32_t outside = 0;            //!< points that are not inside the box
  uint32_t bad = 0;                //!< points that are NaN, Inf, or absurdly far
};

/** Up to kMost points of the vehicle frame, metres, to the map's lattice: transformed in double
 * precision, then rounded to whole millimetres, halves away from zero (geometry::toMillimetres).
 * The same bits on every processor. */
void toLattice(
    const LatticeBox& box,
    const float* x,
    const float* y,
    const float* z,
    size_t size,
    LatticePoints& points);
}  // namespace traverse::traversability_grid
