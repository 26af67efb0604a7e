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
  void findAlongColumns(std::span<const uint8_t> obstacles);
  void lowestOfWindow(const int16_t* along, size_t columns);
  void lowestOfEnvelope(const int16_t* along, int32_t columns);
  void decode(const int16_t* along, NearestRow& nearest) const;

  int32_t columns_;
  int32_t rows_;
  int32_t most_squared_;
  int32_t reach_ = 0;
  bool is_narrow_ = false;
  std::vector<int16_t> along_;  // rows to the nearest obstacle of the column; beyond reach_: none

  struct Parabola
  {
    int32_t column = 0;
    int32_t first = 0;  // column from which on it is the lowest
  };

  std::vector<int16_t> heights_;  // of a row, with reach_ columns more on either side
  std::vector<int16_t> source_;   // column of the nearest obstacle, less the cell's own
  std::vector<Parabola> envelope_;
};
}  // namespace traverse::layers
