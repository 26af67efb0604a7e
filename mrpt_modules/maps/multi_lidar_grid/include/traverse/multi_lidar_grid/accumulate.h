// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/layers/wrapped_grid.h>
#include <traverse/multi_lidar_grid/params.h>
#include <traverse/multi_lidar_grid/state.h>

namespace traverse::multi_lidar_grid
{
/** One look at a cell. */
struct Look
{
  UnitCell cell;  //!< unknown: beams passed where the obstacle was hit, too high to free the cell
  poses::TimeNs stamp = 0;
  uint32_t sensor_bit = 0;
};

/** Adds looks to cells: a hit makes an obstacle at once; passes take it away.
 *
 * `sweeps`: as many passes in a row as would have hit it with 95 % if it still stood, by the share
 * of looks that hit it before: clear_after_sweeps for what was hit by every look, more for a fence
 * seen edge-on. Passes older than the last hit say nothing; nor do, for kOthersWait_s after it,
 * those of sensors that never hit the cell: what one sensor sees and another overlooks stays. A
 * beam that passes through an obstacle where it was hit, but too high to know the cell free, is a
 * pass too: enough of them leave it unknown. Of a ditch a beam that skims over it is
 * half a pass, one that met ground in its cell a whole one.
 * `log_odds`: hits and passes shift the odds. Unknown erases nothing either way. */
class Accumulator
{
 public:
  explicit Accumulator(const Params& params);

  static constexpr double kOthersWait_s = 0.25;

  void add(Cell& cell, const Look& look) const;

  /** All cells of a unit map that lie in the region of the accumulated one. `mapper` has just made
   * it. An obstacle that its cloud did not meet is contradicted only where beams went through at
   * the heights at which it was hit: those below a table say nothing of the table. */
  void add(
      layers::WrappedGrid<Cell>& cells,
      const UnitMap& map,
      const UnitMapper& mapper,
      uint32_t sensor_bit) const;

 private:
  void hit(Cell& cell, const Look& look) const;
  void pass(Cell& cell, const Look& look) const;
  bool isContradicted(const Cell& cell) const;

  bool log_odds_;
  int clear_after_;
  int hit_step_;
  int pass_step_;
  int most_;
};
}  // namespace traverse::multi_lidar_grid
