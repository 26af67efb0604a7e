// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/lattice.h>
#include <traverse/layers/height_slabs.h>
#include <traverse/traversability_grid/lattice_points.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace traverse::traversability_grid
{
/** Two sums of 32 bits that are added to at once. A product of a number and a pair is the pair of
 * the products, as long as these fit. */
using SumPair = uint64_t;

constexpr SumPair pairOf(uint64_t low, uint64_t high)
{
  return low | (high << 32U);
}

constexpr int64_t lowOf(SumPair pair)
{
  return static_cast<int64_t>(pair & 0xFFFFFFFFU);
}

constexpr int64_t highOf(SumPair pair)
{
  return static_cast<int64_t>(pair >> 32U);
}

/** Sums of one scan's points in one height slab of one cell: layers::HeightSlab in a single cache
 * line. */
struct alignas(64) ScanSlab
{
  SumPair x_y = 0;
  SumPair z_n = 0;
  SumPair xx_xy = 0;
  SumPair yy_yz = 0;
  SumPair zz_xz = 0;
  geometry::CellIndex cell;
  int32_t level = 0;
  uint32_t next = 0;  //!< the cell's next slab beyond its first one, or ScanCells::kNone
  uint16_t min_z_mm = std::numeric_limits<uint16_t>::max();
  uint16_t max_z_mm = 0;

  /** Most points whose sums fit. */
  static uint32_t mostPoints(int32_t cell_mm, int32_t slab_mm)
  {
    const auto side = static_cast<uint64_t>(std::max(cell_mm, slab_mm));
    return static_cast<uint32_t>(std::numeric_limits<uint32_t>::max() / (side * side));
  }

  uint32_t n() const { return static_cast<uint32_t>(highOf(z_n)); }

  void add(uint64_t x_mm, uint64_t y_mm, uint64_t z_mm)
  {
    x_y += pairOf(x_mm, y_mm);
    z_n += pairOf(z_mm, 1);
    xx_xy += x_mm * pairOf(x_mm, y_mm);
    yy_yz += y_mm * pairOf(y_mm, z_mm);
    zz_xz += z_mm * pairOf(z_mm, x_mm);
    min_z_mm = std::min(min_z_mm, static_cast<uint16_t>(z_mm));
    max_z_mm = std::max(max_z_mm, static_cast<uint16_t>(z_mm));
  }

  layers::HeightSlab sums(poses::TimeNs stamp) const
  {
    return {level,         -1,           n(),           min_z_mm,      max_z_mm,
            stamp,         lowOf(x_y),   highOf(x_y),   lowOf(z_n),    lowOf(xx_xy),
            highOf(xx_xy), lowOf(yy_yz), highOf(zz_xz), highOf(yy_yz), lowOf(zz_xz)};
  }
};

static_assert(sizeof(ScanSlab) == 64);

/** The cells that one scan touches, numbered from 0 as the scan meets them, with the sums of its
 * points. A point costs the same in a window of any size; memory goes by the cells and tiles (32 x
 * 32 cells, those of layers::TileGrid) touched and, 4 bytes each, by the tiles of the window. */
class ScanCells
{
 public:
  static constexpr uint32_t kNone = std::numeric_limits<uint32_t>::max();

  struct Limits
  {
    uint32_t slab_points = 0;  //!< ScanSlab::mostPoints()
    size_t tiles = 0;          //!< points that would need more are refused
  };

  /** Forgets the scan before. Points to come lie in `window`; its edges are of 2^20 cells at most.
   */
  void begin(const geometry::CellRect& window, const Limits& most, size_t points);

  /** Adds the next points of the scan; rows and columns from the window's smallest corner. */
  void add(const LatticePoints& points);

  /** Leaves out the cells for which is_gone[number]; the others are numbered anew, in order. */
  void remove(const std::vector<bool>& is_gone);

  bool empty() const { return cells_.empty(); }

  size_t size() const { return cells_.size(); }

  /** Points that found no tile. */
  uint64_t refused() const { return refused_; }

  geometry::CellIndex cell(uint32_t number) const { return cells_[number].cell; }

  /** The cell's number; kNone where the scan did not touch it. */
  uint32_t numberOf(geometry::CellIndex cell) const
  {
    const int32_t column = cell.x - origin_.x;
    const int32_t row = cell.y - origin_.y;
    const bool is_known =
        cell.x >= origin_.x && cell.y >= origin_.y && column < columns_ && row < rows_;
    return is_known ? numbers_[entryOf(directory_[tileOf(column, row)], column, row)] : kNone;
  }

  /** For each point of the scan, in its order, the number of its cell; kNone where it is in none.
   */
  std::span<const uint32_t> ofPoints() const { return of_points_; }

  /** Calls f(CellIndex) with the smallest cell of each tile that has a cell of the scan. */
  template <class F>
  void forEachTile(F&& f) const
  {
    const auto across = static_cast<size_t>(columns_ >> kShift);
    for (const size_t tile : tiles_)
    {
      const auto row = static_cast<int32_t>(tile / across);
      const auto column = static_cast<int32_t>(tile % across);
      f(geometry::CellIndex{origin_.x + (column << kShift), origin_.y + (row << kShift)});
    }
  }

  /** Calls f(const ScanSlab&) for the slabs of a cell, in no certain order; more than one may have
   * the same level. */
  template <class F>
  void forEachSlab(uint32_t number, F&& f) const
  {
    f(cells_[number]);
    for (uint32_t i = cells_[number].next; i != kNone; i = more_[i].next)
    {
      f(more_[i]);
    }
  }

 private:
  static constexpr int32_t kShift = 5;
  static constexpr int32_t kSide = 1 << kShift;
  static constexpr uint32_t kBlock = kSide * kSide;

  /** Of a cell counted from origin_. */
  size_t tileOf(int32_t column, int32_t row) const
  {
    return static_cast<size_t>(row >> kShift) * static_cast<size_t>(columns_ >> kShift) +
           static_cast<size_t>(column >> kShift);
  }

  static uint32_t entryOf(uint32_t block, int32_t column, int32_t row)
  {
    const int32_t in_tile = ((row & (kSide - 1)) << kShift) | (column & (kSide - 1));
    return block * kBlock + static_cast<uint32_t>(in_tile);
  }

  uint32_t entryOf(geometry::CellIndex cell) const;
  uint32_t findEntry(int32_t column, int32_t row);
  bool makeBlock(size_t tile);
  void number(const LatticePoints& points);
  ScanSlab& otherSlab(uint32_t number, int32_t level);

  geometry::CellIndex origin_;      // on a tile's corner
  geometry::CellIndex shift_;       // of the window's smallest corner, from there
  int32_t columns_ = 0, rows_ = 0;  // from origin_, of whole tiles
  Limits most_;
  uint64_t refused_ = 0;
  std::vector<uint32_t> directory_;  // block of each tile of the window; 0: none of its cells
  std::vector<size_t> tiles_;        // that have one
  std::vector<uint32_t> numbers_;    // of the cells, in blocks; the first block stays without any
  std::vector<ScanSlab> cells_;      // by number; each is the first slab of its cell
  std::vector<ScanSlab> more_;
  std::vector<uint32_t> of_points_;
};
}  // namespace traverse::traversability_grid
