// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/lattice.h>
#include <traverse/layers/layer_set.h>

#include <cstddef>
#include <vector>

namespace traverse::navigation
{
/** Which cells of a map share ground with which cells of an extent on another lattice. */
class Overlap
{
 public:
  /** Cells of the extent have sides of lattice.cell_mm. Throws std::invalid_argument where a cell
   * has no size, or a layer has not as many cells as the set. */
  Overlap(
      const layers::LayerSet& set,
      const geometry::Lattice& lattice,
      const geometry::CellRect& extent);

  /** f(place in the map's layers, place in the extent), row by row, for each pair of cells. */
  template <class F>
  void forEach(F&& f) const
  {
    for (const Pair& row : rows_)
    {
      const size_t from = row.theirs * their_width_;
      const size_t to = row.ours * our_width_;
      for (const Pair& column : columns_)
      {
        f(from + column.theirs, to + column.ours);
      }
    }
  }

 private:
  struct Pair
  {
    size_t theirs, ours;
  };

  /** One axis: cells [min, max) of a side in millimetres. */
  struct Axis
  {
    int64_t cell_mm, min, max;
  };

  static std::vector<Pair> pairs(const Axis& theirs, const Axis& ours);

  size_t their_width_;
  size_t our_width_;
  std::vector<Pair> columns_;
  std::vector<Pair> rows_;
};
}  // namespace traverse::navigation
