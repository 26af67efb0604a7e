// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "beam_fans.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace traverse::multi_lidar_grid
{
/** A straight way over the region's cells; lengths in m from the region's corner. */
struct GroundRay
{
  float x_m = 0;
  float y_m = 0;
  Direction to;

  struct Place
  {
    int32_t x = 0;
    int32_t y = 0;
  };

  /** How far the ray is within a region that is `side_m` wide: from .x_m to .y_m along it; empty
   * where the first is greater. */
  struct Stretch
  {
    float from_m = 0;
    float to_m = 0;
  };

  Stretch within(float side_m) const
  {
    Stretch stretch = {0, 1e9F};
    clip(x_m, to.x, side_m, stretch);
    clip(y_m, to.y, side_m, stretch);
    return stretch;
  }

  Place placeAt(float along_m, float by_cell, int32_t edge) const
  {
    return {
        std::clamp(static_cast<int32_t>((x_m + to.x * along_m) * by_cell), 0, edge - 1),
        std::clamp(static_cast<int32_t>((y_m + to.y * along_m) * by_cell), 0, edge - 1)};
  }

 private:
  static void clip(float at_m, float step, float side_m, Stretch& stretch)
  {
    if (std::abs(step) < 1e-6F)
    {
      stretch.to_m = at_m >= 0 && at_m < side_m ? stretch.to_m : -1;
      return;
    }
    const float a = -at_m / step;
    const float b = (side_m - at_m) / step;
    stretch.from_m = std::max(stretch.from_m, std::min(a, b));
    stretch.to_m = std::min(stretch.to_m, std::max(a, b));
  }
};

/** Something of x and y, in the first two of four, so that both are worked on at once. */
using FloatPair = float __attribute__((vector_size(16)));
using IntPair = int32_t __attribute__((vector_size(16)));

/** A ray over a region of cells, and what all walks along it have in common. */
struct GroundWay
{
  GroundRay ray;
  GroundRay::Stretch inside;
  float cell_m = 1;
  float by_cell = 1;      //!< 1 / m
  int32_t edge = 1;       //!< cells along the region
  FloatPair step_m = {};  //!< along the ray, from column to column and from row to row
  IntPair sign = {};      //!< of those steps; 0: never

  GroundWay() = default;

  GroundWay(const GroundRay& along, float cell, int32_t edge_cells) :
      ray(along),
      inside(along.within(cell * static_cast<float>(edge_cells))),
      cell_m(cell),
      by_cell(1 / cell),
      edge(edge_cells)
  {
    setAxis(0, along.to.x);
    setAxis(1, along.to.y);
  }

  GroundRay::Place placeAt(float along_m) const { return ray.placeAt(along_m, by_cell, edge); }

  /** Where the ray leaves a cell along each axis. */
  FloatPair nextOf(const GroundRay::Place& cell) const
  {
    return FloatPair{
        nextOf(ray.x_m, ray.to.x, cell.x, sign[0]), nextOf(ray.y_m, ray.to.y, cell.y, sign[1])};
  }

 private:
  static constexpr float kNever_m = 1e9F;

  void setAxis(int axis, float step)
  {
    const bool is_along = std::abs(step) >= 1e-6F;
    step_m[axis] = is_along ? cell_m / std::abs(step) : kNever_m;
    sign[axis] = is_along ? (step > 0 ? 1 : -1) : 0;
  }

  float nextOf(float at_m, float step, int32_t cell, int32_t to) const
  {
    const int32_t border = cell + (to > 0 ? 1 : 0);
    return to == 0 ? kNever_m : (static_cast<float>(border) * cell_m - at_m) / step;
  }
};

/** The cells that a ray crosses, one after the other; neighbours share an edge. */
class CellWalk
{
 public:
  CellWalk(const GroundWay& way, float along_m) :
      edge_(static_cast<uint32_t>(way.edge)), step_m_(way.step_m), sign_(way.sign), at_m_(along_m)
  {
    const GroundRay::Place place = way.placeAt(along_m);
    place_ = IntPair{place.x, place.y};
    next_m_ = way.nextOf(place);
  }

  GroundRay::Place place() const { return {place_[0], place_[1]}; }

  /** Where the ray enters the cell. */
  float at_m() const { return at_m_; }

  /** Half-way between that and where the ray leaves it. */
  float middle_m() const
  {
    const FloatPair y_m = __builtin_shufflevector(next_m_, next_m_, 1, 1, 1, 1);
    return (at_m_ + std::min(next_m_[0], y_m[0])) / 2;
  }

  /** To the next cell; false where the region ends. Without a branch: nobody guesses which way. */
  bool next()
  {
    constexpr IntPair kIsY = {0, -1};
    const FloatPair x_m = __builtin_shufflevector(next_m_, next_m_, 0, 0, 0, 0);
    const FloatPair y_m = __builtin_shufflevector(next_m_, next_m_, 1, 1, 1, 1);
    const IntPair goes = (x_m < y_m) ^ kIsY;  // all bits of the axis that is crossed first
    at_m_ = std::min(x_m[0], y_m[0]);
    next_m_ = goes ? next_m_ + step_m_ : next_m_;
    place_ += goes & sign_;
    return (static_cast<uint32_t>(place_[0]) < edge_) & (static_cast<uint32_t>(place_[1]) < edge_);
  }

 private:
  uint32_t edge_;
  FloatPair step_m_;
  IntPair sign_;
  FloatPair next_m_ = {};
  IntPair place_ = {};
  float at_m_;
};
}  // namespace traverse::multi_lidar_grid
