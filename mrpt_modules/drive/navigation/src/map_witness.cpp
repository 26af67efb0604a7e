// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "map_witness.h"

#include "ground_slope.h"
#include "layer_data.h"
#include "sure_friction.h"
#include "text.h"

#include <traverse/geometry/exact_trig.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace traverse::navigation
{
namespace
{
using layers::Fact;

constexpr std::array<std::string_view, 4> kStates = {
    "", "may be driven", "obstacle", "obstacle, the ground falls away"};

std::string joined(const std::string& a, const std::string& b)
{
  return a.empty() || b.empty() ? a + b : a + ", " + b;
}

std::string textOf(const CellSays& said, float price)
{
  std::string text(kStates.at(static_cast<size_t>(said.state)));
  if (std::isfinite(said.speed_mps))
  {
    text = joined(text, "at " + inShort(said.speed_mps) + " m/s at most");
  }
  if (price > 0)
  {
    text = joined(text, "price + " + inShort(price));
  }
  return text.empty() ? "nothing" : text;
}
}  // namespace

void MapWitness::tell(
    const LayerRule& rule,
    const geometry::Vehicle& vehicle,
    const CostParams& params,
    std::vector<Fact>& facts) const
{
  const layers::Layer* layer = map_.set->find(rule.layer);
  if (layer == nullptr)
  {
    return;
  }
  const PriceRamp ramp = rule.ramp != nullptr ? rule.ramp(vehicle, params) : PriceRamp{};
  CellSays worst;
  float price = 0;
  std::optional<double> value;
  overlap_.forEach(
      [&](size_t theirs, size_t)
      {
        const double here = valueOf(*layer, theirs);
        const CellSays said = rule.says != nullptr ? rule.says(here, params) : CellSays{};
        const float price_here = ramp.at(static_cast<float>(here));
        if (!value || said.state > worst.state || price_here > price)
        {
          value = here;
        }
        price = std::max(price, price_here);
        worst.state = std::max(worst.state, said.state);
        worst.speed_mps = std::min(worst.speed_mps, said.speed_mps);
      });
  facts.push_back(
      {map_.name + ": " + std::string(rule.layer),
       value ? inShort(*value) + ": " + textOf(worst, price) : "outside of the map"});
}

void MapWitness::tellSlope(
    const geometry::Vehicle& vehicle, const CostParams& params, std::vector<Fact>& facts) const
{
  const GroundSlope slope(*map_.set, vehicle, params);
  if (!slope.isTold())
  {
    return;
  }
  const layers::Layer* const own = map_.set->find("slope_deg");
  float price = 0;
  std::string text;
  overlap_.forEach(
      [&](size_t theirs, size_t)
      {
        const auto columns = static_cast<size_t>(map_.set->extent.width());
        const auto column = static_cast<int32_t>(theirs % columns);
        const auto row = static_cast<int32_t>(theirs / columns);
        const float here = slope.priceAt(column, row);
        if (!(here > price))
        {
          return;
        }
        price = here;
        const double tangent = slope.tangentByGround(column, row);
        text = std::isnan(tangent) ? inShort(valueOf(*own, theirs)) + " deg by slope_deg"
                                   : inShort(geometry::angleOf(tangent, 1) * 180 / geometry::kPi) +
                                         " deg by ground_height";
      });
  facts.push_back({map_.name + ": slope", price > 0 ? text + ": " + textOf({}, price) : "none"});
}

void MapWitness::tellFriction(const CostParams& params, std::vector<Fact>& facts) const
{
  const SureFriction friction(*map_.set, params);
  if (!friction.isTold())
  {
    return;
  }
  float least = std::numeric_limits<float>::quiet_NaN();
  overlap_.forEach([&](size_t theirs, size_t) { least = std::fmin(least, friction.at(theirs)); });
  facts.push_back(
      {map_.name + ": friction",
       std::isnan(least)
           ? "not known"
           : inShort(least) + " for sure: " + textOf({}, priceOfFriction(least, params))});
}
}  // namespace traverse::navigation
