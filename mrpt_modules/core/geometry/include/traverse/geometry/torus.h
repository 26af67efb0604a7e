// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/lattice.h>

#include <array>
#include <cstddef>
#include <span>

namespace traverse::geometry
{
/** Cells of the plane in a square array that wraps round in x and y: cell (i, j) is stored in
 * column i mod side, row j mod side, whatever its sign (paper 5, equation 1, in integers). */
class Torus
{
 public:
  static constexpr int32_t kLargestSide = 1 << 14;

  /** The torus for a region of so many cells along its edge: its side is a power of two and more
   * than sqrt(2) times the edge, so that the region also fits turned. Throws
   * std::invalid_argument for edges below 1 or of more than kLargestSide. */
  explicit Torus(int32_t region_edge);

  int32_t side() const { return mask_ + 1; }

  size_t size() const { return static_cast<size_t>(side()) * static_cast<size_t>(side()); }

  size_t indexOf(CellIndex cell) const
  {
    return static_cast<size_t>(cell.y & mask_) << shift_ | static_cast<size_t>(cell.x & mask_);
  }

  /** Cells from this one on along x that are stored one after the other. */
  int32_t runFrom(int32_t x) const { return side() - (x & mask_); }

 private:
  int32_t mask_ = 0;
  uint32_t shift_ = 0;
};

/** Rectangles that a region lost in a move; none of them overlap. */
class DroppedCells
{
 public:
  void add(const CellRect& rect)
  {
    if (!rect.empty())
    {
      rects_[count_++] = rect;
    }
  }

  std::span<const CellRect> rects() const& { return {rects_.data(), count_}; }

  std::span<const CellRect> rects() const&& = delete;  // a view into what is gone

 private:
  std::array<CellRect, 2> rects_;
  size_t count_ = 0;
};

/** A square of cells that follows something. Its middle cell is at edge / 2 from its first. */
class RollingRegion
{
 public:
  /** Around cell (0, 0). Throws std::invalid_argument for edges below 1 or of more than
   * Torus::kLargestSide. */
  explicit RollingRegion(int32_t edge);

  const CellRect& rect() const { return rect_; }

  /** The cells of which this one is in the middle become the region; returns those that it lost:
   * a strip along x, one along y, or all of them after a jump. Cells stay exact to 1e7 m and beyond
   * (|centre| <= 2^31 - 2^15, otherwise std::invalid_argument). */
  DroppedCells moveTo(CellIndex centre);

 private:
  CellRect rect_;
};
}  // namespace traverse::geometry
