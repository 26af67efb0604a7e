// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/lattice.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>

namespace traverse::navigation
{
/** A place of the map frame. */
struct Place
{
  double x_m = 0;
  double y_m = 0;
};

inline double distance_m(Place a, Place b)
{
  const double dx = b.x_m - a.x_m;
  const double dy = b.y_m - a.y_m;
  return std::sqrt(dx * dx + dy * dy);
}

/** Column (or row) of a coordinate within kFarthest_m; without rounding to millimetres, so that a
 * place just before a cell's edge is not taken for one behind it. */
inline int32_t columnOf(double metres, const geometry::Lattice& lattice)
{
  return static_cast<int32_t>(
      std::floor(metres * geometry::kMillimetresPerMetre / lattice.cell_mm));
}

inline geometry::CellIndex cellOf(Place place, const geometry::Lattice& lattice)
{
  return {columnOf(place.x_m, lattice), columnOf(place.y_m, lattice)};
}

/** One coordinate of a walk from cell to cell, in cells. */
class WalkAxis
{
 public:
  WalkAxis(double from_m, double to_m, const geometry::Lattice& lattice) :
      at_(columnOf(from_m, lattice)),
      from_(from_m * geometry::kMillimetresPerMetre / lattice.cell_mm),
      along_(to_m * geometry::kMillimetresPerMetre / lattice.cell_mm - from_),
      left_(std::abs(columnOf(to_m, lattice) - at_)),
      step_(along_ < 0 ? -1 : 1)
  {
    findEdge();
  }

  int32_t at() const { return at_; }

  int32_t next() const { return at_ + step_; }

  /** Share of the way at which the cell ends; infinity where there are no more. */
  double edge() const { return edge_; }

  bool isOver() const { return left_ == 0; }

  void step()
  {
    at_ += step_;
    --left_;
    findEdge();
  }

 private:
  void findEdge()
  {
    edge_ = left_ == 0 ? std::numeric_limits<double>::infinity()
                       : (at_ + (step_ > 0 ? 1 : 0) - from_) / along_;
  }

  int32_t at_;
  double from_;
  double along_;
  int32_t left_;
  int32_t step_;
  double edge_ = 0;
};

/** Calls f(cell, share of the way within it) for the cells of a straight way in their order, until
 * f says false; returns whether it never did. Where the way goes through a corner, both cells
 * beside it are told too, with share 0: nothing slips between two cells that touch there. */
template <class F>
bool overCells(Place from, Place to, const geometry::Lattice& lattice, F&& f)
{
  constexpr double kSameCorner = 1e-9;  // share of the way; far above what rounding does
  WalkAxis x(from.x_m, to.x_m, lattice);
  WalkAxis y(from.y_m, to.y_m, lattice);
  double done = 0;
  while (!x.isOver() || !y.isOver())
  {
    const double edge = x.edge() < y.edge() ? x.edge() : y.edge();
    const bool over_x = x.edge() <= edge + kSameCorner;
    const bool over_y = y.edge() <= edge + kSameCorner;
    if (!f(geometry::CellIndex{x.at(), y.at()}, edge - done))
    {
      return false;
    }
    if (over_x && over_y &&
        (!f(geometry::CellIndex{x.next(), y.at()}, 0.0) ||
         !f(geometry::CellIndex{x.at(), y.next()}, 0.0)))
    {
      return false;
    }
    done = edge;
    if (over_x)
    {
      x.step();
    }
    if (over_y)
    {
      y.step();
    }
  }
  return f(geometry::CellIndex{x.at(), y.at()}, 1 - done);
}
}  // namespace traverse::navigation
