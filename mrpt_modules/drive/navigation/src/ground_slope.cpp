// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ground_slope.h"

#include "layer_data.h"

#include <traverse/geometry/exact_trig.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace traverse::navigation
{
namespace
{
constexpr double kLeast_deg = 1;  // a vehicle that takes no slope at all

double steepest_deg(const geometry::Vehicle& vehicle)
{
  return std::max(vehicle.max_slope_deg, kLeast_deg);
}

/** The mean of the rises to both sides; one of them where the other is not known. */
inline float meanRise(float before, float here, float after)
{
  const float up = after - here;
  const float down = here - before;
  const float both = (up + down) / 2;
  const float one = up == up ? up : down;
  return both == both ? both : one;
}
}  // namespace

GroundSlope::GroundSlope(
    const layers::LayerSet& set, const geometry::Vehicle& vehicle, const CostParams& params) :
    ground_(dataOf<float>(set, "ground_height")),
    own_deg_(dataOf<float>(set, "slope_deg")),
    columns_(set.extent.width()),
    rows_(set.extent.height()),
    reach_cells_(std::max<int32_t>(
        1, static_cast<int32_t>(std::lround(kHalfBase_m / set.lattice.cell_m())))),
    reach_m_(static_cast<float>(reach_cells_ * set.lattice.cell_m())),
    price_(static_cast<float>(params.slope_price)),
    steepest_deg_(static_cast<float>(steepest_deg(vehicle))),
    steepest_tangent_(
        static_cast<float>(geometry::tangentOf(steepest_deg(vehicle) * geometry::kPi / 180)))
{
}

float GroundSlope::rise(int32_t column, int32_t row, int32_t step_x, int32_t step_y) const
{
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  const auto height = [&](int32_t x, int32_t y)
  { return x >= 0 && x < columns_ && y >= 0 && y < rows_ ? (*ground_)[at(x, y)] : kNan; };
  const float here = (*ground_)[at(column, row)];
  return meanRise(
      height(column - step_x, row - step_y), here, height(column + step_x, row + step_y));
}

float GroundSlope::tangentByGround(int32_t column, int32_t row) const
{
  if (ground_ == nullptr)
  {
    return std::numeric_limits<float>::quiet_NaN();
  }
  const float along_x = rise(column, row, reach_cells_, 0);
  const float along_y = rise(column, row, 0, reach_cells_);
  return std::sqrt(along_x * along_x + along_y * along_y) / reach_m_;
}

float GroundSlope::priceAt(int32_t column, int32_t row) const
{
  float share = tangentByGround(column, row) / steepest_tangent_;
  if (std::isnan(share) && own_deg_ != nullptr)
  {
    share = (*own_deg_)[at(column, row)] / steepest_deg_;
  }
  return share > 0 ? std::min(share, 1.0F) * price_ : 0.0F;
}

void GroundSlope::raise(int32_t column, int32_t row, size_t length, float* worst) const
{
  const auto end = column + static_cast<int32_t>(length);
  const bool has_rows = row >= reach_cells_ && row < rows_ - reach_cells_;
  const int32_t inside = std::clamp(has_rows ? reach_cells_ : end, column, end);
  const int32_t outside = std::clamp(has_rows ? columns_ - reach_cells_ : end, inside, end);
  for (int32_t x = column; x < end; ++x)
  {
    if (x == inside && inside < outside && ground_ != nullptr)
    {
      raiseInside(x, row, static_cast<size_t>(outside - inside), worst + (x - column));
      x = outside - 1;
      continue;
    }
    float& price = worst[x - column];
    price = std::max(price, priceAt(x, row));
  }
}

void GroundSlope::raiseInside(int32_t column, int32_t row, size_t length, float* worst) const
{
  const float* const here = ground_->data() + at(column, row);
  const float* const low = here - static_cast<ptrdiff_t>(reach_cells_) * columns_;
  const float* const high = here + static_cast<ptrdiff_t>(reach_cells_) * columns_;
  const float* const own = own_deg_ != nullptr ? own_deg_->data() + at(column, row) : here;
  const float per_deg = own_deg_ != nullptr ? 1 / steepest_deg_ : 0;
  const float per_rise = 1 / (reach_m_ * steepest_tangent_);
  const ptrdiff_t reach = reach_cells_;
  const float price = price_;
  for (size_t i = 0; i < length; ++i)
  {
    const auto k = static_cast<ptrdiff_t>(i);
    const float along_x = meanRise(here[k - reach], here[k], here[k + reach]);
    const float along_y = meanRise(low[k], here[k], high[k]);
    const float by_ground = std::sqrt(along_x * along_x + along_y * along_y) * per_rise;
    const float share = by_ground == by_ground ? by_ground : own[k] * per_deg;
    const float added = (share < 1 ? share : 1.0F) * price;
    worst[k] = share == share && added > worst[k] ? added : worst[k];
  }
}
}  // namespace traverse::navigation
