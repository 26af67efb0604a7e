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

/** The cells that a ray crosses, one after the other; neighbours share an edge. */
class CellWalk
{
 public:
  CellWalk(const GroundRay& ray, float along_m, float cell_m, int32_t edge) :
      place_(ray.placeAt(along_m, 1 / cell_m, edge)), edge_(edge), at_m_(along_m)
  {
    setUp(ray.x_m, ray.to.x, cell_m, place_.x, x_);
    setUp(ray.y_m, ray.to.y, cell_m, place_.y, y_);
  }

  const GroundRay::Place& place() const { return place_; }

  /** Where the ray enters the cell. */
  float at_m() const { return at_m_; }

  /** Half-way between that and where the ray leaves it. */
  float middle_m() const { return (at_m_ + std::min(x_.next_m, y_.next_m)) / 2; }

  /** To the next cell; false where the region ends. */
  bool next()
  {
    const bool along_x = x_.next_m < y_.next_m;
    Axis& axis = along_x ? x_ : y_;
    int32_t& coordinate = along_x ? place_.x : place_.y;
    at_m_ = axis.next_m;
    axis.next_m += axis.step_m;
    coordinate += axis.sign;
    return static_cast<uint32_t>(coordinate) < static_cast<uint32_t>(edge_);
  }

 private:
  struct Axis
  {
    float next_m = 1e9F;  // along the ray, where it leaves the cell
    float step_m = 1e9F;
    int32_t sign = 0;
  };

  static void setUp(float at_m, float step, float cell_m, int32_t cell, Axis& axis)
  {
    if (std::abs(step) < 1e-6F)
    {
      return;
    }
    axis.sign = step > 0 ? 1 : -1;
    axis.step_m = cell_m / std::abs(step);
    axis.next_m = (static_cast<float>(cell + (step > 0 ? 1 : 0)) * cell_m - at_m) / step;
  }

  GroundRay::Place place_;
  int32_t edge_;
  float at_m_;
  Axis x_;
  Axis y_;
};
}  // namespace traverse::multi_lidar_grid
