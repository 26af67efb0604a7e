// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/ground/column.h>

#include <cstdint>
#include <span>
#include <vector>

namespace traverse::ground
{
/** A square of cells with one plane of ground. */
struct Patch
{
  enum class State : uint8_t
  {
    unseen,
    queued,
    settled,
    border,  //!< outside the window; never settled
  };

  static constexpr float kFar = 1e6F;

  float z_m = 0;  //!< in the middle
  float slope_x = 0;
  float slope_y = 0;
  float gap_m = kFar;  //!< to the nearest patch with ground points
  float trust = 0;     //!< weight in predictions; 0 until it is settled
  int32_t block = -1;  //!< its columns, or -1: see PatchGrid::columnsOf
  State state = State::unseen;
  bool measured = false;
};

/** The window's patches, and which columns lie where. Patches lie on the absolute lattice, with two
 * of border around the window, so that neighbours need no check. */
class PatchGrid
{
 public:
  static constexpr int32_t kBorder = 2;

  void reset(
      std::span<const Column> columns,
      const geometry::Lattice& lattice,
      const geometry::CellRect& window,
      double patch_m);

  int32_t stride() const { return stride_; }

  float side_m() const { return side_m_; }

  /** Cells along a patch's edge. */
  size_t cells() const { return static_cast<size_t>(cells_); }

  /** Of the middle of a patch's i-th column or row of cells from the patch's middle. */
  float offset_m(size_t i) const { return (static_cast<float>(i) + 0.5F) * cell_m() - side_m_ / 2; }

  float cell_m() const { return static_cast<float>(cell_m_); }

  std::vector<Patch>& patches() { return patches_; }

  const std::vector<Patch>& patches() const { return patches_; }

  Patch& at(int32_t i) { return patches_[static_cast<size_t>(i)]; }

  const Patch& at(int32_t i) const { return patches_[static_cast<size_t>(i)]; }

  /** Numbers of a patch's columns by cell (rows upward), -1 where a cell has none; empty for a
   * patch without columns. */
  std::span<const int32_t> columnsOf(const Patch& patch) const;

  /** The patch of a cell of the window. */
  int32_t patchOf(geometry::CellIndex cell) const
  {
    return (by_y_[static_cast<size_t>(cell.y - window_.min.y)].patch + kBorder) * stride_ +
           by_x_[static_cast<size_t>(cell.x - window_.min.x)].patch + kBorder;
  }

  /** The column of a cell, or -1; cells just outside the window have none. */
  int32_t columnAt(int32_t x, int32_t y) const;

  /** Where a cell's middle lies between the middles of four patches. */
  struct Between
  {
    int32_t patch = 0;  //!< the lower left one; it may be border
    float right = 0;    //!< of the middle, 0..1 from the left to the right patches
    float up = 0;
  };

  Between between(geometry::CellIndex cell) const
  {
    const Place& column = by_x_[static_cast<size_t>(cell.x - window_.min.x)];
    const Place& row = by_y_[static_cast<size_t>(cell.y - window_.min.y)];
    return {(row.lower + kBorder) * stride_ + column.lower + kBorder, column.part, row.part};
  }

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

  int32_t columns() const { return columns_; }

  int32_t rows() const { return rows_; }

 private:
  struct Place
  {
    int32_t patch = 0;  //!< column or row
    int32_t cell = 0;   //!< within the patch
    int32_t lower = 0;  //!< the last patch whose middle is not beyond the cell's
    float part = 0;     //!< of the way from that middle to the next
  };

  std::vector<Place> placesOf(int32_t min, int32_t max, int32_t first) const;

  size_t blockSize() const { return static_cast<size_t>(cells_) * static_cast<size_t>(cells_); }

  void putColumns(std::span<const Column> columns);

  geometry::CellRect window_;
  double cell_m_ = 0;
  int32_t cells_ = 1;  //!< along a patch's edge
  float side_m_ = 0;
  geometry::CellIndex first_;  //!< patch of the window's smallest corner
  int32_t columns_ = 0;
  int32_t rows_ = 0;
  int32_t stride_ = 0;
  std::vector<Place> by_x_, by_y_;  //!< of the window's columns and rows of cells
  std::vector<Patch> patches_;
  std::vector<int32_t> slots_;  //!< blocks of cells_ x cells_ column numbers
};
}  // namespace traverse::ground
