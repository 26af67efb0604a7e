// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "patch_grid.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace traverse::ground
{
/** The ground's plane at a column, above the reference. */
struct GroundPlane
{
  float z_m = 0;             //!< in the cell's middle
  float tilt_m = 0;          //!< how much higher it is in the cell's highest corner
  bool is_measured = false;  //!< a patch there has ground points; else it is a guess
};

/** How far the surfaces of columns stand off the ground: what a wheel would feel. Points are
 * samples, so the farthest of them is nearer to the ground than the surface's farthest place; that
 * is made up for by how many of them are off the ground, and by what the columns around show. */
class Relief
{
 public:
  void reset(size_t columns);

  /** Of columns()[column_at], one of the patch's. most_span_m: of a flat column there. */
  void measure(
      const PatchGrid& grid,
      int32_t patch,
      uint32_t column_at,
      const GroundPlane& plane,
      float most_span_m);

  /** Sets relief_m and is_low_growth of all verdicts, which are by the columns' numbers. */
  void finish(const PatchGrid& grid, std::vector<Verdict>& verdicts);

 private:
  /** A column's heights above the ground's plane. */
  struct Shape
  {
    float relief_m = 0;
    float low_m = 0;
    float mean_m = 0;
    float top_m = 0;

    bool isMostlyLow(float share) const;
  };

  /** A flat column of few points above the ground. */
  struct Raised
  {
    int32_t patch = 0;
    uint32_t column = 0;
    float most_span_m = 0;
    float tilt_m = 0;
  };

  void amongOthers(const PatchGrid& grid, int32_t patch, size_t i, Verdict& verdict) const;

  std::vector<Shape> shapes_;  // by column of the grid
  std::vector<Raised> raised_;
};
}  // namespace traverse::ground
