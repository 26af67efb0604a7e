// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ridge.h"

#include <traverse/layers/distance_transform.h>

#include <vector>

namespace traverse::layers
{
/** strip = default. Where the directions to the nearest obstacle of two neighbouring cells differ
 * by 120 degrees or more, a strip is cut. What it needs beyond is the Ridge's: soft cells between
 * two obstacles that leave the vehicle room. */
class Strip
{
 public:
  Strip(const Buffer& buffer, int32_t hard_squared);

  /** The zones of rows up to y are set; rows come in order, `before` is of row y - 1. */
  void addRow(size_t y, const NearestRow& now, const NearestRow& before);

  void finish() { ridge_.finish(); }

 private:
  /** A cell and its nearest obstacle, in cells. */
  struct Side
  {
    size_t cell;
    int32_t squared, dx, dy;
  };

  static bool differ(const Side& a, const Side& b, int64_t apart_squared);
  void findApart(const NearestRow& now, const NearestRow& before);
  void addPair(const Side& a, const Side& b, int32_t step_x, int32_t step_y);

  Buffer buffer_;
  int16_t least_apart_;
  int64_t wide_apart_squared_;
  Ridge ridge_;
  std::vector<uint8_t> apart_;
};

/** strip = paper: soft cells where the Laplacian (5 x 5, scale 1/48) of the distance to the hard
 * buffer, in cells, is below -0.3. is_hard: of unknown cells too. soft_cells: width of the soft
 * buffer. */
void cutByLaplacian(const Buffer& buffer, std::span<const uint8_t> is_hard, int32_t soft_cells);
}  // namespace traverse::layers
