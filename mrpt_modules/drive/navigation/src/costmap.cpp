// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cost_fields.h"
#include "outline.h"

#include <traverse/navigation/cost_rules.h>
#include <traverse/navigation/costmap.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace traverse::navigation
{
namespace
{
using layers::BufferZone;
using layers::OccupancyState;

void checkExtent(const geometry::CellRect& extent)
{
  constexpr int64_t kMostCells = 4096;
  const int64_t width = int64_t{extent.max.x} - extent.min.x;
  const int64_t height = int64_t{extent.max.y} - extent.min.y;
  if (width <= 0 || height <= 0 || width > kMostCells || height > kMostCells)
  {
    throw std::invalid_argument("a costmap has 1 to 4096 cells along its edges");
  }
}

/** It stands there, so it can be driven over. */
void openUnderVehicle(
    const Costmap& costmap, const geometry::Vehicle& vehicle, std::vector<uint8_t>& states)
{
  const auto open = [&](geometry::CellIndex c)
  {
    uint8_t& state = states[costmap.indexOf(c)];
    if (state == static_cast<uint8_t>(OccupancyState::unknown))
    {
      state = static_cast<uint8_t>(OccupancyState::free);
    }
  };
  Outline(vehicle, costmap.stand).forEachMiddle(costmap.lattice, costmap.extent, open);
}

std::vector<uint8_t> zonesOf(
    const Costmap& costmap,
    const std::vector<uint8_t>& states,
    const geometry::Vehicle& vehicle,
    const CostParams& params)
{
  const layers::BufferParams buffer = {
      costmap.lattice.cell_m(), hardBuffer_m(params, vehicle, costmap.lattice),
      params.soft_buffer_m, params.strip};
  if (!costmap.is_unknown_planned)
  {
    return layers::safetyBuffer(states, costmap.extent.width(), buffer);
  }
  // What is planned through must keep its distance in the unknown, too.
  std::vector<uint8_t> as_free = states;
  for (uint8_t& state : as_free)
  {
    state = std::max(state, static_cast<uint8_t>(OccupancyState::free));
  }
  return layers::safetyBuffer(as_free, costmap.extent.width(), buffer);
}

Passage passageOf(uint8_t state, uint8_t zone)
{
  if (state >= static_cast<uint8_t>(OccupancyState::obstacle))
  {
    return Passage::obstacle;
  }
  if (zone == static_cast<uint8_t>(BufferZone::hard))
  {
    return Passage::hard;
  }
  if (zone == static_cast<uint8_t>(BufferZone::soft))
  {
    return Passage::soft;
  }
  return state == static_cast<uint8_t>(OccupancyState::unknown) ? Passage::unknown : Passage::open;
}

/** What becomes of each state in each zone. */
struct PassageTable
{
  static constexpr size_t kZones = 4;
  static constexpr size_t kPlaces = 4 * kZones;  // states that CostFields knows

  explicit PassageTable(const CostParams& params)
  {
    const auto soft = static_cast<float>(params.soft_price) - kLeastPrice;
    const auto unseen = static_cast<float>(params.unknown_price) - kLeastPrice;
    for (size_t place = 0; place < kPlaces; ++place)
    {
      const auto state = static_cast<uint8_t>(place / kZones);
      passage[place] = passageOf(state, static_cast<uint8_t>(place % kZones));
      price[place] = (passage[place] >= Passage::soft ? soft : 0.0F) + (state == 0 ? unseen : 0.0F);
    }
  }

  std::array<Passage, kPlaces> passage{};
  std::array<float, kPlaces> price{};
};

/** Passages, and what they and the unknown add to prices. */
void setPassages(
    Costmap& costmap,
    const std::vector<uint8_t>& states,
    const std::vector<uint8_t>& zones,
    const CostParams& params)
{
  const PassageTable table(params);
  Passage* const passage = costmap.passage.data();
  float* const price = costmap.price.data();
  for (size_t i = 0; i < states.size(); ++i)
  {
    const size_t place = states[i] * PassageTable::kZones + zones[i];
    passage[i] = table.passage[place];
    if (zones[i] == static_cast<uint8_t>(BufferZone::strip))
    {
      const auto columns = static_cast<size_t>(costmap.extent.width());
      costmap.strip.push_back(
          {costmap.extent.min.x + static_cast<int32_t>(i % columns),
           costmap.extent.min.y + static_cast<int32_t>(i / columns)});
    }
    price[i] += table.price[place];
  }
}
}  // namespace

Costmap costmapOf(
    std::span<const MapLayers> maps,
    const geometry::Lattice& lattice,
    const geometry::CellRect& extent,
    const geometry::Pose2& stand,
    const geometry::Vehicle& vehicle,
    const CostParams& params)
{
  checkExtent(extent);
  CostFields fields(maps, {lattice, extent}, vehicle, params);
  Costmap costmap;
  costmap.lattice = lattice;
  costmap.extent = extent;
  costmap.stand = stand;
  costmap.is_unknown_planned = params.unknown == UnknownPolicy::costly;
  costmap.price = fields.takePrices();
  costmap.speed_mps = fields.takeSpeeds();
  costmap.obstacle_m = fields.takeHeights();
  costmap.friction = fields.takeFriction();
  costmap.passage.resize(costmap.price.size());
  std::vector<uint8_t> states = fields.takeStates();
  openUnderVehicle(costmap, vehicle, states);
  setPassages(costmap, states, zonesOf(costmap, states, vehicle, params), params);
  return costmap;
}
}  // namespace traverse::navigation
