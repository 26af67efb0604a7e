// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/navigation/motion.h>
#include <traverse/navigation/terrain.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace traverse::navigation
{
/** One number for each place and heading, by squares of cells and 72 headings. Memory is taken only
 * where something was put. */
class HeadingBins
{
 public:
  static constexpr int kHeadings = 72;
  static constexpr int32_t kNone = -1;

  /** About how wide a square is at least; wider cells are squares themselves. */
  static constexpr double kWidth_m = 0.2;

  void clear(const geometry::Lattice& lattice, const geometry::CellRect& extent)
  {
    lattice_ = lattice;
    extent_ = extent;
    cells_ = std::max(1, static_cast<int32_t>(std::lround(kWidth_m / lattice.cell_m())));
    columns_ = static_cast<size_t>((extent.width() + cells_ - 1) / cells_);
    block_.assign(columns_ * static_cast<size_t>((extent.height() + cells_ - 1) / cells_), kNone);
    blocks_.clear();
  }

  double width_m() const { return cells_ * lattice_.cell_m(); }

  /** Of a pose in the extent. */
  int32_t& at(const Posed& pose)
  {
    const geometry::CellIndex c = cellOf(pose.stand.place, lattice_);
    int32_t& block = block_
        [static_cast<size_t>((c.y - extent_.min.y) / cells_) * columns_ +
         static_cast<size_t>((c.x - extent_.min.x) / cells_)];
    if (block == kNone)
    {
      block = static_cast<int32_t>(blocks_.size());
      blocks_.emplace_back().fill(kNone);
    }
    const int turn =
        static_cast<int>((pose.yaw_rad + geometry::kPi) * (kHeadings / (2 * geometry::kPi)));
    return blocks_[static_cast<size_t>(block)][static_cast<size_t>(turn % kHeadings)];
  }

 private:
  geometry::Lattice lattice_;
  geometry::CellRect extent_;
  int32_t cells_ = 1;
  size_t columns_ = 0;
  std::vector<int32_t> block_;
  std::vector<std::array<int32_t, kHeadings>> blocks_;
};
}  // namespace traverse::navigation
