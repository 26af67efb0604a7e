// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/layers/layer_set.h>
#include <traverse/navigation/cost_params.h>

#include <cstddef>
#include <vector>

namespace traverse::navigation
{
/** The friction that a map is sure of. */
class SureFriction
{
 public:
  SureFriction(const layers::LayerSet& set, const CostParams& params);

  /** The map has a layer to tell it by. */
  bool isTold() const { return mean_ != nullptr; }

  /** Coefficient, kLeastFriction at least; NaN where the map does not know it. */
  float at(size_t cell) const;

  static constexpr float kLeastFriction = 0.05F;  //!< wet ice's: nothing on the ground is smoother

 private:
  const std::vector<float>* mean_;
  const std::vector<float>* deviation_;
  float sigmas_;
};

/** What a coefficient of friction adds to the price of a metre; 0 for NaN. */
float priceOfFriction(float friction, const CostParams& params);
}  // namespace traverse::navigation
