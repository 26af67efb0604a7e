// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/ground/column.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace traverse::ground
{
/** Four numbers that are added and multiplied at once. */
using Quad = float __attribute__((vector_size(16)));

/** The foot of a column of several surfaces: so much above its lowest point. */
inline constexpr float kFoot_m = 0.02F;

/** A slope less what may be noise. */
inline float beyondNoise(float slope)
{
  constexpr float kLevel = 0.05F;
  return slope - std::clamp(slope, -kLevel, kLevel);
}

/** A square of cells with one plane of ground. */
struct alignas(32) Patch
{
  static constexpr float kFar = 1e6F;

  /** Height in the middle, slopes, and the weight in predictions, which is 0 until the patch is
   * settled; together, because predictions read and write them together. */
  Quad plane = {};
  float gap_m = kFar;  //!< to the nearest patch with ground points
  float measured = 0;  //!< 1 where its own columns made the plane, else 0
  int32_t block = -1;  //!< its columns', or -1

  float z_m() const { return plane[0]; }

  float slopeX() const { return plane[1]; }

  float slopeY() const { return plane[2]; }

  float trust() const { return plane[3]; }

  bool isSettled() const { return trust() > 0; }
};

/** A column among those of its patch. */
struct PlacedColumn
{
  float low_m = 0;
  float mean_m = 0;
  float top_m = 0;
  float highest_m = 0;
  float noise_m = 0;
  uint32_t n = 0;
  uint32_t number = 0;  //!< as it was given
  uint16_t x = 0;       //!< its cell, from the patch's corner
  uint16_t y = 0;

  float span_m() const { return top_m - low_m; }
};

/** The window's patches, and their columns. Patches lie on the absolute lattice, with two of border
 * around the window, so that neighbours need no check. */
class PatchGrid
{
 public:
  static constexpr int32_t kBorder = 2;

  /** A patch's columns: a range of columns(). */
  struct Block
  {
    int32_t patch = 0;
    uint32_t first = 0;
    uint32_t size = 0;
  };

  /** A column or row of cells within a patch, or just outside. */
  struct Along
  {
    float offset_m = 0;  //!< of the cells' middle from the patch's
    int32_t lower = 0;   //!< 0, or -1 where the cells lie before the patch's middle
    float part = 0;      //!< of the way from the middle of patch `lower` to the next
    int32_t patch = 0;   //!< 0; -1 and 1 for cells of the patches before and after
    int32_t cell = 0;    //!< within that patch
  };

  /** Throws std::length_error for windows of too many patches. */
  void reset(
      std::span<const Column> columns,
      const geometry::Lattice& lattice,
      const geometry::CellRect& window,
      double patch_m);

  int32_t stride() const { return stride_; }

  float side_m() const { return side_m_; }

  float cell_m() const { return static_cast<float>(cell_m_); }

  Patch& at(int32_t i) { return patches_[static_cast<size_t>(i)]; }

  const Patch& at(int32_t i) const { return patches_[static_cast<size_t>(i)]; }

  /** Whether spreading may go there; false for the border. */
  bool isOpen(int32_t i) const { return is_open_[static_cast<size_t>(i)] != 0; }

  void close(int32_t i) { is_open_[static_cast<size_t>(i)] = 0; }

  /** Of all patches with columns. */
  std::span<const Block> blocks() const { return blocks_; }

  /** All columns, patch after patch; the order within one is the given one. */
  std::span<const PlacedColumn> columns() const { return columns_; }

  std::span<const PlacedColumn> columnsOf(const Block& block) const
  {
    return columns().subspan(block.first, block.size);
  }

  std::span<const PlacedColumn> columnsOf(const Patch& patch) const
  {
    return patch.block < 0 ? std::span<const PlacedColumn>()
                           : columnsOf(blocks_[static_cast<size_t>(patch.block)]);
  }

  /** For cells -1 to one beyond the patch. */
  const Along& along(int32_t cell) const
  {
    const int32_t i = cell + 1;
    return along_[static_cast<size_t>(i)];
  }

  /** The patch that holds a cell; -1 for cells outside the window. */
  int32_t patchOf(geometry::CellIndex cell) const
  {
    return window_.contains(cell)
               ? by_y_[static_cast<size_t>(cell.y - window_.min.y)].patch * stride_ +
                     by_x_[static_cast<size_t>(cell.x - window_.min.x)].patch
               : -1;
  }

  /** Calls f(i) for the columns()[i] of the nine cells around one of a patch, and in it. */
  template <class F>
  void forEachAround(int32_t patch, const PlacedColumn& column, F&& f) const;

  /** Of a place of the map frame, which may lie outside: x and y count patches from the middle of
   * the first. */
  struct Position
  {
    float x = 0;
    float y = 0;
  };

  Position positionOf(double x_m, double y_m) const;

  /** The patch at a whole position, or -1 outside the window. */
  int32_t patchAt(int32_t column, int32_t row) const;

 private:
  /** A column or row of cells of the window. */
  struct Place
  {
    int32_t patch = 0;  //!< counted from the border's
    uint16_t cell = 0;  //!< within the patch
  };

  void layOut(const geometry::Lattice& lattice, const geometry::CellRect& window, double patch_m);
  void clear();
  std::vector<Along> alongPatch() const;
  void placesOf(int32_t min, int32_t max, std::vector<Place>& places) const;
  void countColumns(std::span<const Column> columns);
  void putColumns(std::span<const Column> columns);

  size_t slotOf(int32_t block, int32_t x, int32_t y) const
  {
    const auto cells = static_cast<size_t>(cells_);
    return (static_cast<size_t>(block) * cells + static_cast<size_t>(y)) * cells +
           static_cast<size_t>(x);
  }

  geometry::CellRect window_;
  double cell_m_ = 0;
  int32_t cells_ = 1;  //!< along a patch's edge
  float side_m_ = 0;
  geometry::CellIndex first_;  //!< patch of the window's smallest corner
  int32_t patch_columns_ = 0;
  int32_t patch_rows_ = 0;
  int32_t stride_ = 0;
  std::vector<Along> along_;
  std::vector<Place> by_x_, by_y_;  //!< of the window's columns and rows of cells
  std::vector<Patch> patches_;
  std::vector<uint8_t> is_open_;
  std::vector<Block> blocks_;
  std::vector<int32_t> block_of_;  //!< by number of the column
  std::vector<PlacedColumn> columns_;
  std::vector<int32_t> slots_;  //!< of each block cells_ x cells_ indices of columns_, or -1
};

template <class F>
void PatchGrid::forEachAround(int32_t patch, const PlacedColumn& column, F&& f) const
{
  for (int32_t y = column.y - 1; y <= column.y + 1; ++y)
  {
    for (int32_t x = column.x - 1; x <= column.x + 1; ++x)
    {
      const Along& at_x = along(x);
      const Along& at_y = along(y);
      const int32_t block = at(patch + at_y.patch * stride_ + at_x.patch).block;
      const int32_t i = block < 0 ? -1 : slots_[slotOf(block, at_x.cell, at_y.cell)];
      if (i >= 0)
      {
        f(static_cast<size_t>(i));
      }
    }
  }
}
}  // namespace traverse::ground
