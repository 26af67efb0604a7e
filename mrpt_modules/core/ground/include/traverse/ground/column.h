// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/lattice.h>

#include <cstdint>
#include <limits>

namespace traverse::ground
{
/** What a cell holds from its lowest point up to the first gap that the vehicle fits under. Heights
 * are metres above a reference that the caller chooses once for all columns and seeds. */
struct Column
{
  geometry::CellIndex cell;
  uint32_t n = 0;
  float low_m = 0;
  float mean_m = 0;
  float top_m = 0;      //!< up to which something is taken to stand, of which less may be seen
  float highest_m = 0;  //!< of its points
  float noise_m = 0;    //!< noise alone takes points so far off a surface; 0: they scatter by more
};

/** A place where the vehicle stands or stood: the ground there is known without any point. */
struct Seed
{
  double x_m = 0;  //!< map frame
  double y_m = 0;
  float z_m = 0;  //!< of the ground, above the columns' reference
  float slope_x = 0;
  float slope_y = 0;
  float radius_m = 0;  //!< how far around it the ground is taken to be this plane
};

/** The ground in a patch, with points or without. */
struct PatchPlane
{
  float z_m = std::numeric_limits<float>::quiet_NaN();  //!< in its middle; NaN: not reached
  float slope_x = 0;
  float slope_y = 0;
  float gap_m = std::numeric_limits<float>::infinity();  //!< to the nearest with ground points

  bool isKnown() const { return z_m == z_m; }
};

/** What the estimate says of a column. */
struct Verdict
{
  static constexpr float kNone = -std::numeric_limits<float>::infinity();

  /** Height of the ground in the cell's middle, above the reference; NaN where it is not known. */
  float ground_m = std::numeric_limits<float>::quiet_NaN();

  /** The cell's points up to this height are ground; kNone where none is. */
  float limit_m = kNone;

  /** How far the cell's surface stands off the smooth ground, up or down: of a clod its height, of
   * a rut its depth. 0 where nothing measured the ground there. */
  float relief_m = 0;

  /** Ground was measured within two metres, not only foretold. */
  bool is_measured = false;

  /** Few points above many on the ground, amid cells that are alike: grass, and no fence. */
  bool is_low_growth = false;

  bool isKnown() const { return ground_m == ground_m; }

  /** Ground was met in the cell, or may be there. */
  bool bearsGround() const { return limit_m != kNone; }
};
}  // namespace traverse::ground
