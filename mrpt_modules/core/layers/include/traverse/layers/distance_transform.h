// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace traverse::layers
{
/** The nearest obstacle of each cell of a row: from centre to centre, in cells. */
struct NearestRow
{
  static constexpr int32_t kNone = std::numeric_limits<int32_t>::max();

  std::vector<int32_t> squared;  //!< distance, squared; kNone where none is within reach
  std::vector<int16_t> dx;       //!< to the obstacle, columns; 0 where there is none
  std::vector<int16_t> dy;       //!< rows
};

/** Exact Euclidean distance transform that tells the nearest obstacle itself (feature transform),
 * up to a reach and a row at a time, so that nobody stores more of it than needed. Of obstacles
 * equally near, the one in the lower column counts, of those the one in the lower row. The time
 * does not depend on the number of obstacles, except that it is less where there are none within
 * reach (after Meijster, Roerdink and Hesselink: columns first, then rows). */
class DistanceTransform
{
 public:
  static constexpr int32_t kLongestReach_cells = 16383;

  /** Obstacles are cells that are not 0 in a dense grid of `columns` cells a row; those farther
   * than sqrt(most_squared) cells count as none. Throws std::invalid_argument where the number of
   * cells is no multiple of the columns, or the reach is below 0 or above kLongestReach_cells. */
  DistanceTransform(std::span<const uint8_t> obstacles, int32_t columns, int32_t most_squared);

  int32_t rows() const { return rows_; }

  /** 0 <= y < rows(). Uses the transform's own work space. */
  void row(int32_t y, NearestRow& nearest);

 private:
  size_t findEnvelope(const int16_t* along);

  struct Parabola
  {
    int32_t column = 0;
    int32_t first = 0;  // column from which on it is the lowest
  };

  int32_t columns_;
  int32_t rows_;
  std::vector<int16_t> reach_by_rows_;
  std::vector<int16_t> along_;  // rows to the column's nearest obstacle; out of reach: one too many
  std::vector<Parabola> envelope_;
};
}  // namespace traverse::layers
