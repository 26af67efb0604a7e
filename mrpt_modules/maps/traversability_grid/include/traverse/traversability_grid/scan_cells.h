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
/** Sums of one scan's points in one height slab of one cell: layers::HeightSlab in 32 bits, a
 * single cache line. */
struct alignas(64) ScanSlab
{
  geometry::CellIndex cell;
  int32_t level = 0;
  uint32_t next = 0;  //!< the cell's next slab in ScanCells::more(), or kNone
  uint32_t n = 0;
  uint16_t min_z_mm = 0;
  uint16_t max_z_mm = 0;
  uint32_t x = 0, y = 0, z = 0;
  uint32_t xx = 0, xy = 0, yy = 0, xz = 0, yz = 0, zz = 0;

  /** Most points whose sums fit. */
  static uint32_t mostPoints(int32_t cell_mm, int32_t slab_mm)
  {
    const auto side = static_cast<uint64_t>(std::max(cell_mm, slab_mm));
    return static_cast<uint32_t>(std::numeric_limits<uint32_t>::max() / (side * side));
  }

  void add(uint32_t x_mm, uint32_t y_mm, uint32_t z_mm)
  {
    min_z_mm = std::min(min_z_mm, static_cast<uint16_t>(z_mm));
    max_z_mm = std::max(max_z_mm, static_cast<uint16_t>(z_mm));
    ++n;
    x += x_mm;
    y += y_mm;
    z += z_mm;
    xx += x_mm * x_mm;
    xy += x_mm * y_mm;
    yy += y_mm * y_mm;
    xz += x_mm * z_mm;
    yz += y_mm * z_mm;
    zz += z_mm * z_mm;
  }

  layers::HeightSlab sums(poses::TimeNs stamp) const;
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
    const Position p = positionOf(cell.x - origin_.x, cell.y - origin_.y);
    const bool is_known = cell.x >= origin_.x && cell.y >= origin_.y &&
                          cell.x - origin_.x < columns_ && cell.y - origin_.y < rows_;
    return is_known ? blocks_[directory_[p.tile]][p.offset] : kNone;
  }

  /** For each point of the scan, in its order, the number of its cell; kNone where it is in none.
   */
  std::span<const uint32_t> ofPoints() const { return of_points_; }

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
  using Block = std::array<uint32_t, static_cast<size_t>(kSide) * kSide>;

  struct Position
  {
    size_t tile = 0;
    size_t offset = 0;
  };

  /** Of a cell counted from origin_. */
  Position positionOf(int32_t column, int32_t row) const
  {
    const int32_t in_tile = ((row & (kSide - 1)) << kShift) | (column & (kSide - 1));
    return {
        static_cast<size_t>(row >> kShift) * static_cast<size_t>(columns_ >> kShift) +
            static_cast<size_t>(column >> kShift),
        static_cast<size_t>(in_tile)};
  }

  void number(const LatticePoints& points);
  uint32_t numberAt(int32_t column, int32_t row, int32_t level);
  bool makeBlock(size_t tile);
  uint32_t& entryOf(geometry::CellIndex cell);
  ScanSlab& otherSlab(uint32_t number, int32_t level);

  geometry::CellIndex origin_;      // on a tile's corner
  geometry::CellIndex shift_;       // of the window's smallest corner, from there
  int32_t columns_ = 0, rows_ = 0;  // from origin_, of whole tiles
  Limits most_;
  uint64_t refused_ = 0;
  std::vector<uint32_t> directory_;  // block of each tile of the window; 0: none of its cells
  std::vector<size_t> tiles_;        // that have one
  std::vector<Block> blocks_;        // numbers of cells; the first stays without any
  std::vector<ScanSlab> cells_;      // by number; each is the first slab of its cell
  std::vector<ScanSlab> more_;
  std::vector<uint32_t> of_points_;
};
}  // namespace traverse::traversability_grid
