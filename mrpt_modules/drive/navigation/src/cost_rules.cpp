// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/geometry/outline.h>
#include <traverse/navigation/cost_rules.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace traverse::navigation
{
namespace
{
using layers::OccupancyState;

CellSays occupancy(double code, const CostParams& /*params*/)
{
  if (code == static_cast<double>(OccupancyState::free) ||
      code == static_cast<double>(OccupancyState::overhang))
  {
    return {OccupancyState::free};
  }
  if (code == static_cast<double>(OccupancyState::obstacle))
  {
    return {OccupancyState::obstacle};
  }
  const bool is_negative = code == static_cast<double>(OccupancyState::negative);
  return {is_negative ? OccupancyState::negative : OccupancyState::unknown};
}

CellSays traversability(double code, const CostParams& params)
{
  constexpr double kFlat = 1;
  constexpr double kSmall = 2;
  constexpr double kLarge = 3;
  constexpr double kObstacle = 4;
  if (code == kSmall || code == kLarge)
  {
    const double speed = code == kSmall ? params.small_roughness_mps : params.large_roughness_mps;
    return {OccupancyState::free, static_cast<float>(speed)};
  }
  if (code == kFlat)
  {
    return {OccupancyState::free};
  }
  return {code == kObstacle ? OccupancyState::obstacle : OccupancyState::unknown};
}

CellSays outline(double code, const CostParams& /*params*/)
{
  return {code != 0 && !std::isnan(code) ? OccupancyState::obstacle : OccupancyState::unknown};
}

PriceRamp index(const geometry::Vehicle& /*vehicle*/, const CostParams& params)
{
  constexpr double kWorst = 100;
  return {static_cast<float>(params.index_price / kWorst), static_cast<float>(params.index_price)};
}

constexpr std::array<LayerRule, 4> kRules = {
    {{"occupancy_state", occupancy, nullptr},
     {"traversability_class", traversability, nullptr},
     {"guaranteed_outline", outline, nullptr},
     {"traversability_index", nullptr, index}}};
}  // namespace

std::span<const LayerRule> layerRules()
{
  return kRules;
}

layers::LayerChoice costLayers()
{
  // beside the rules': slopes, heights and friction
  std::vector<std::string> names = {"ground_height", "slope_deg", "height_max",
                                    "height_min",    "friction",  "friction_deviation"};
  for (const LayerRule& rule : kRules)
  {
    names.emplace_back(rule.layer);
  }
  return {names};
}

double hardBuffer_m(
    const CostParams& params, const geometry::Vehicle& vehicle, const geometry::Lattice& lattice)
{
  if (params.hard_buffer_m > 0)
  {
    return params.hard_buffer_m;
  }
  return geometry::halfWidth_m(vehicle) + lattice.cell_m() * std::sqrt(0.5);
}
}  // namespace traverse::navigation
