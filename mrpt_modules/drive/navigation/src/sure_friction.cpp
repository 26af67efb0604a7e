// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sure_friction.h"

#include "layer_data.h"

#include <algorithm>
#include <limits>

namespace traverse::navigation
{
SureFriction::SureFriction(const layers::LayerSet& set, const CostParams& params) :
    mean_(dataOf<float>(set, "friction")),
    deviation_(dataOf<float>(set, "friction_deviation")),
    sigmas_(static_cast<float>(params.friction_sigmas))
{
}

float SureFriction::at(size_t cell) const
{
  const float mean = (*mean_)[cell];
  const float deviation = deviation_ != nullptr ? (*deviation_)[cell] : 0;
  if (!(mean >= 0))
  {
    return std::numeric_limits<float>::quiet_NaN();
  }
  const float sure = deviation > 0 ? mean - sigmas_ * deviation : mean;
  return std::max(sure, kLeastFriction);
}

float priceOfFriction(float friction, const CostParams& params)
{
  const auto good = static_cast<float>(params.good_friction);
  const auto price = static_cast<float>(params.grip_price);
  return friction < good ? price * (1 - friction / good) : 0;
}
}  // namespace traverse::navigation
