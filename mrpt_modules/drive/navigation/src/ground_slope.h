// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/vehicle.h>
#include <traverse/layers/layer_set.h>
#include <traverse/navigation/cost_params.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace traverse::navigation
{
/** How steep a map says the ground is: by ground_height kHalfBase_m to both sides of a cell where
 * it is known there, by the cell's own slope_deg elsewhere. */
class GroundSlope
{
 public:
  static constexpr double kHalfBase_m = 0.6;  //!< beyond what a cell's few points scatter over

  GroundSlope(
      const layers::LayerSet& set, const geometry::Vehicle& vehicle, const CostParams& params);

  /** The map has layers to tell it by. */
  bool isTold() const { return ground_ != nullptr || own_deg_ != nullptr; }

  /** Tangent, by ground_height; NaN where that is not known on one side at least in each axis. */
  float tangentByGround(int32_t column, int32_t row) const;

  /** What it adds to the price of a metre, 0 where no slope is known. */
  float priceAt(int32_t column, int32_t row) const;

  /** priceAt() for `length` columns from `column` on, where it is above what is in `worst`. */
  void raise(int32_t column, int32_t row, size_t length, float* worst) const;

 private:
  void raiseInside(int32_t column, int32_t row, size_t length, float* worst) const;
  float rise(int32_t column, int32_t row, int32_t step_x, int32_t step_y) const;

  size_t at(int32_t column, int32_t row) const
  {
    return static_cast<size_t>(row) * static_cast<size_t>(columns_) + static_cast<size_t>(column);
  }

  const std::vector<float>* ground_;
  const std::vector<float>* own_deg_;
  int32_t columns_;
  int32_t rows_;
  int32_t reach_cells_;
  float reach_m_;
  float price_;
  float steepest_deg_;
  float steepest_tangent_;
};
}  // namespace traverse::navigation
