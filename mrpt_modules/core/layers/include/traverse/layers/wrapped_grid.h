// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/torus.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace traverse::layers
{
/** The cells of a region that moves, in memory that does not: a torus (geometry/torus.h). What
 * leaves the region is Cell{} again, so that a cell entered once more never shows old data; moving
 * costs by what leaves. Only cells of region() may be asked for; others are other cells' storage.
 *
 * `Cell` is a small value; Cell{} is an empty cell. */
template <class Cell>
class WrappedGrid
{
 public:
  /** Empty, around cell (0, 0). Throws as geometry::Torus. */
  explicit WrappedGrid(int32_t region_edge) :
      torus_(region_edge), region_(region_edge), cells_(torus_.size())
  {
  }

  const geometry::CellRect& region() const { return region_.rect(); }

  Cell& at(geometry::CellIndex cell) { return cells_[torus_.indexOf(cell)]; }

  const Cell& at(geometry::CellIndex cell) const { return cells_[torus_.indexOf(cell)]; }

  /** Where its cells are: to be copied before loops that write bytes, as the compiler must take
   * those for any memory. Valid as long as the grid. */
  class View
  {
   public:
    explicit View(WrappedGrid& grid) : torus_(grid.torus_), cells_(grid.cells_.data()) {}

    Cell& at(geometry::CellIndex cell) const { return cells_[torus_.indexOf(cell)]; }

   private:
    geometry::Torus torus_;
    Cell* cells_;
  };

  View view() { return View(*this); }

  /** nullptr for cells outside the region. */
  const Cell* get(geometry::CellIndex cell) const
  {
    return region().contains(cell) ? &at(cell) : nullptr;
  }

  /** Puts the cell into the region's middle. f(CellIndex, const Cell&) is called for every cell
   * that leaves, before it is emptied. */
  template <class F>
  void moveTo(geometry::CellIndex centre, F&& f)
  {
    const geometry::DroppedCells dropped = region_.moveTo(centre);
    for (const geometry::CellRect& rect : dropped.rects())
    {
      forEachIn(
          rect,
          [&](geometry::CellIndex cell, Cell& value)
          {
            f(cell, static_cast<const Cell&>(value));
            value = Cell{};
          });
    }
  }

  void moveTo(geometry::CellIndex centre)
  {
    const geometry::DroppedCells dropped = region_.moveTo(centre);
    for (const geometry::CellRect& rect : dropped.rects())
    {
      fill(rect, Cell{});
    }
  }

  void clear() { std::fill(cells_.begin(), cells_.end(), Cell{}); }

  void fill(const geometry::CellRect& part, const Cell& value)
  {
    forEachRunIn(
        part, [&](geometry::CellIndex, std::span<Cell> run)
        { std::fill(run.begin(), run.end(), value); });
  }

  /** Calls f(CellIndex first, std::span<Cell>) for stretches of cells along x that lie one after
   * the other in memory: row by row, by growing x, as in a dense grid of `part`, which must lie
   * within the region. */
  template <class F>
  void forEachRunIn(const geometry::CellRect& part, F&& f)
  {
    runs(*this, part, f);
  }

  template <class F>
  void forEachRunIn(const geometry::CellRect& part, F&& f) const
  {
    runs(*this, part, f);
  }

  /** Calls f(CellIndex, Cell&) in the same order. */
  template <class F>
  void forEachIn(const geometry::CellRect& part, F&& f)
  {
    each(*this, part, f);
  }

  template <class F>
  void forEachIn(const geometry::CellRect& part, F&& f) const
  {
    each(*this, part, f);
  }

  template <class F>
  void forEach(F&& f)
  {
    each(*this, region(), f);
  }

  template <class F>
  void forEach(F&& f) const
  {
    each(*this, region(), f);
  }

 private:
  template <class Self, class F>
  static void runs(Self& self, const geometry::CellRect& part, F& f)
  {
    for (int32_t y = part.min.y; y < part.max.y; ++y)
    {
      for (int32_t x = part.min.x; x < part.max.x;)
      {
        const int32_t n = std::min(part.max.x - x, self.torus_.runFrom(x));
        f(geometry::CellIndex{x, y}, std::span(&self.at({x, y}), static_cast<size_t>(n)));
        x += n;
      }
    }
  }

  template <class Self, class F>
  static void each(Self& self, const geometry::CellRect& part, F& f)
  {
    auto visit = [&f](geometry::CellIndex cell, auto run)
    {
      for (auto& value : run)
      {
        f(cell, value);
        ++cell.x;
      }
    };
    runs(self, part, visit);
  }

  geometry::Torus torus_;
  geometry::RollingRegion region_;
  std::vector<Cell> cells_;
};
}  // namespace traverse::layers
