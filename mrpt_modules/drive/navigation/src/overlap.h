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

  /** f(place in the map's layers, place in the extent, n) for runs of n pairs of cells that follow
   * each other in both, row by row. */
  template <class F>
  void forEachRun(F&& f) const
  {
    for (const Run& row : rows_)
    {
      for (size_t k = 0; k < row.length; ++k)
      {
        const size_t from = (row.theirs + k) * their_width_;
        const size_t to = (row.ours + k) * our_width_;
        for (const Run& columns : columns_)
        {
          f(from + columns.theirs, to + columns.ours, columns.length);
        }
      }
    }
  }

  /** f(place in the map's layers, place in the extent) for each pair of cells. */
  template <class F>
  void forEach(F&& f) const
  {
    forEachRun(
        [&](size_t theirs, size_t ours, size_t length)
        {
          for (size_t k = 0; k < length; ++k)
          {
            f(theirs + k, ours + k);
          }
        });
  }

 private:
  struct Run
  {
    size_t theirs, ours, length;
  };

  /** One axis: cells [min, max) of a side in millimetres. */
  struct Axis
  {
    int64_t cell_mm, min, max;
  };

  static std::vector<Run> runs(const Axis& theirs, const Axis& ours);

  size_t their_width_;
  size_t our_width_;
  std::vector<Run> columns_;
  std::vector<Run> rows_;
};
}  // namespace traverse::navigation
