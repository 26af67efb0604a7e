// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/layers/distance_transform.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace traverse::multi_lidar_grid
{
/** A grid and its buffer, of which strips are cut; rows of `columns` cells. */
struct Buffer
{
  std::span<const uint8_t> states;  //!< codes of layers::OccupancyState
  std::span<uint8_t> zones;         //!< codes of layers::BufferZone
  size_t columns = 1;
};

/** strip = default. Where the directions to the nearest obstacle of two neighbouring cells differ
 * by 120 degrees or more, a strip is cut. From its ends it is led on, along cells between obstacles
 * that leave the vehicle room, while these recede and if that ends in the open: where the walls of
 * a corridor end, the directions soon differ by less, but the buffers still meet. */
class Strip
{
 public:
  Strip(const Buffer& buffer, int32_t hard_squared);

  /** The zones of rows up to y are set; rows come in order, `before` is of row y - 1. */
  void addRow(size_t y, const layers::NearestRow& now, const layers::NearestRow& before);

  /** Leads the strips on and takes back those that are no way. */
  void finish();

 private:
  /** A cell and its nearest obstacle, in cells. */
  struct Side
  {
    size_t cell;
    int32_t squared, dx, dy;
  };

  /** A cell between two obstacles. */
  struct RidgeCell
  {
    size_t cell;
    float distance;
    float farthest = 0;  // distance on the way here; 0: not reached
    size_t from = 0;     // the one before on that way
    bool is_seed = false;
    bool is_counted = false;
  };

  bool isSoft(size_t cell) const;
  static bool isClear(const Side& a, const Side& b, int64_t apart_squared);
  static bool differ(const Side& a, const Side& b);
  void addPair(const Side& a, const Side& b, int32_t step_x, int32_t step_y);
  void mark(const Side& side, uint8_t zone);
  void sortRidge();
  void leadOut();
  std::vector<size_t> pieceFrom(size_t seed);
  bool isWay(const std::vector<size_t>& piece) const;
  size_t ridgeAt(size_t cell) const;
  bool isBesideFree(size_t cell) const;
  void cutBackFrom(size_t at);

  template <class F>
  void forEachNeighbour(size_t cell, F&& f) const;
  template <class F>
  void forEachCorner(size_t cell, F&& f) const;

  Buffer buffer_;
  int32_t least_apart_squared_;
  int32_t wide_apart_squared_;
  std::vector<RidgeCell> ridge_;
};

/** strip = paper: soft cells where the Laplacian (5 x 5, scale 1/48) of the distance to the hard
 * buffer, in cells, is below -0.3. soft_cells: width of the soft buffer. */
void cutByLaplacian(const Buffer& buffer, int32_t soft_cells);
}  // namespace traverse::multi_lidar_grid
