// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "beam_points.h"
#include "rules.h"

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace traverse::multi_lidar_grid
{
/** The returns of a cell, as far as its state depends on them. Heights in mm above one zero. */
struct Column
{
  static constexpr int32_t kNoGround = std::numeric_limits<int32_t>::min();

  int32_t cell = 0;
  int32_t low = 0;
  int32_t high = 0;
  int32_t ground = kNoGround;  //!< by the ground reference
  int32_t limit = 0;           //!< obstacles begin above (paper: at) this height
  int32_t top = 0;             //!< and end here: the vehicle passes below what is higher
  int32_t below = 0;           //!< the highest return that is no higher than limit
  int32_t above = 0;           //!< the lowest return higher than limit
  int32_t hits_to = 0;         //!< the highest return from limit to top
  uint32_t count = 0;          //!< of all returns
  uint32_t count_high = 0;     //!< of those higher than top
};

/** What returns alone make of a cell. */
enum class Returns : uint8_t
{
  nothing,  //!< too little to say
  ground,   //!< ground and nothing on it
  obstacle,
  overhang,  //!< ground, and something above the vehicle
  hanging,   //!< something above the vehicle, the ground not met: who passes below decides
  below,     //!< lower than the ground around by more than negative_depth_m
};

/** Collects the columns of a scan without sorting. */
class CellColumns
{
 public:
  /** Finds the cells with points, and how high those reach. */
  void collect(const BeamPoints& points, size_t cells);

  std::span<Column> columns() { return columns_; }

  std::span<const Column> columns() const { return columns_; }

  /** Second pass, once limit and top of all columns are set. */
  void compare(const BeamPoints& points);

  /** The column of a cell, or nullptr. */
  const Column* find(int32_t cell) const
  {
    const int32_t slot = slots_[static_cast<size_t>(cell)];
    return slot < 0 ? nullptr : &columns_[static_cast<size_t>(slot)];
  }

 private:
  std::vector<int32_t> slots_;  // of each cell, its column's or -1
  std::vector<Column> columns_;
};

/** Sets limit and top by the rule that holds for the cell: without a ground reference always the
 * paper's. */
void setLimits(const Rules& rules, int32_t obstacle_mm, Column& column);

/** The state by the returns, after CellColumns::compare(). */
Returns judge(const Rules& rules, const Column& column);
}  // namespace traverse::multi_lidar_grid
