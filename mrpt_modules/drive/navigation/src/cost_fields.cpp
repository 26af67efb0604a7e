// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cost_fields.h"

#include "ground_slope.h"
#include "layer_data.h"
#include "sure_friction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <variant>

namespace traverse::navigation
{
namespace
{
using layers::Layer;
using layers::LayerSet;
using layers::OccupancyState;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr size_t kCodes = 256;

/** Of a map that has none: an empty set. */
const LayerSet& layersOf(const MapLayers& map)
{
  static const LayerSet kNone;
  return map.set != nullptr ? *map.set : kNone;
}

/** What a layer's codes say, asked once for each. */
struct CodeTable
{
  CodeTable(const LayerRule& rule, const CostParams& params)
  {
    for (size_t code = 0; code < kCodes; ++code)
    {
      const CellSays said = rule.says(static_cast<double>(code), params);
      state[code] = static_cast<uint8_t>(said.state);
      speed[code] = said.speed_mps;
    }
  }

  std::array<uint8_t, kCodes> state{};
  std::array<float, kCodes> speed{};
};
}  // namespace

ObstacleHeights::ObstacleHeights(const LayerSet& set) :
    classes_(dataOf<uint8_t>(set, "traversability_class")),
    top_(dataOf<float>(set, "height_max")),
    bottom_(dataOf<float>(set, "height_min")),
    ground_(dataOf<float>(set, "ground_height"))
{
}

float ObstacleHeights::at(size_t cell) const
{
  if (!isObstacle(cell))
  {
    return kNan;
  }
  const float ground = ground_ != nullptr ? (*ground_)[cell] : kNan;
  const float lowest = bottom_ != nullptr ? (*bottom_)[cell] : kNan;
  const float height = (*top_)[cell] - (std::isnan(ground) ? lowest : ground);
  return height > 0 ? height : kNan;
}

CostFields::CostFields(
    std::span<const MapLayers> maps,
    const CostFrame& frame,
    const geometry::Vehicle& vehicle,
    const CostParams& params) :
    maps_(maps)
{
  const auto size =
      static_cast<size_t>(frame.extent.width()) * static_cast<size_t>(frame.extent.height());
  states_.resize(size, 0);
  prices_.resize(size, kLeastPrice);
  speeds_.resize(size, std::numeric_limits<float>::infinity());
  heights_.resize(size, kNan);
  for (const MapLayers& map : maps_)
  {
    overlaps_.emplace_back(layersOf(map), frame.lattice, frame.extent);
  }
  for (const LayerRule& rule : layerRules())
  {
    const std::vector<Source> sources = sourcesOf(rule.layer);
    if (rule.ramp != nullptr)
    {
      addPrices(sources, rule.ramp(vehicle, params));
      continue;
    }
    for (const Source& source : sources)
    {
      readStates(source, rule, params);
    }
  }
  addSlopes(vehicle, params);
  addFriction(params);
  for (size_t i = 0; i < maps_.size(); ++i)
  {
    readHeights(layersOf(maps_[i]), overlaps_[i]);
  }
}

std::vector<CostFields::Source> CostFields::sourcesOf(std::string_view layer) const
{
  std::vector<Source> sources;
  for (size_t i = 0; i < maps_.size(); ++i)
  {
    const Layer* found = layersOf(maps_[i]).find(layer);
    if (found != nullptr)
    {
      sources.push_back({found, &overlaps_[i]});
    }
  }
  return sources;
}

void CostFields::readStates(const Source& source, const LayerRule& rule, const CostParams& params)
{
  uint8_t* const states = states_.data();
  float* const speeds = speeds_.data();
  if (const auto* codes = std::get_if<std::vector<uint8_t>>(&source.layer->data))
  {
    const CodeTable table(rule, params);
    source.overlap->forEach(
        [&, of = codes->data()](size_t theirs, size_t ours)
        {
          states[ours] = std::max(states[ours], table.state[of[theirs]]);
          speeds[ours] = std::min(speeds[ours], table.speed[of[theirs]]);
        });
    return;
  }
  source.overlap->forEach(
      [&](size_t theirs, size_t ours)
      {
        const CellSays said = rule.says(valueOf(*source.layer, theirs), params);
        states[ours] = std::max(states[ours], static_cast<uint8_t>(said.state));
        speeds[ours] = std::min(speeds[ours], said.speed_mps);
      });
}

void CostFields::readHeights(const LayerSet& set, const Overlap& overlap)
{
  const ObstacleHeights heights(set);
  if (heights.areKnown())
  {
    overlap.forEach(
        [&](size_t theirs, size_t ours)
        {
          if (heights.isObstacle(theirs))
          {
            heights_[ours] = std::fmax(heights_[ours], heights.at(theirs));  // NaN where both are
          }
        });
  }
  const auto* const codes = dataOf<uint8_t>(set, "occupancy_state");
  if (codes != nullptr)
  {
    overlap.forEach(
        [&](size_t theirs, size_t ours)
        {
          if ((*codes)[theirs] == static_cast<uint8_t>(OccupancyState::negative))
          {
            heights_[ours] = std::fmax(heights_[ours], kFallsAway);
          }
        });
  }
}

void CostFields::addPrices(const std::vector<Source>& sources, const PriceRamp& ramp)
{
  if (sources.empty())
  {
    return;
  }
  worst_.assign(prices_.size(), 0);  // what several cells say counts once
  float* const worst = worst_.data();
  for (const Source& source : sources)
  {
    const auto raise = [&](const auto& data)
    {
      source.overlap->forEach(
          [&, values = data.data()](size_t theirs, size_t ours)
          { worst[ours] = std::max(worst[ours], ramp.at(static_cast<float>(values[theirs]))); });
    };
    std::visit(raise, source.layer->data);
  }
  for (size_t i = 0; i < worst_.size(); ++i)
  {
    prices_[i] += worst[i];
  }
}

// What several cells say counts once, the least.
void CostFields::addFriction(const CostParams& params)
{
  for (size_t i = 0; i < maps_.size(); ++i)
  {
    const SureFriction friction(layersOf(maps_[i]), params);
    if (!friction.isTold())
    {
      continue;
    }
    friction_.resize(prices_.size(), kNan);
    overlaps_[i].forEach([&](size_t theirs, size_t ours)
                         { friction_[ours] = std::fmin(friction_[ours], friction.at(theirs)); });
  }
  for (size_t i = 0; i < friction_.size(); ++i)
  {
    prices_[i] += priceOfFriction(friction_[i], params);
  }
}

void CostFields::addSlopes(const geometry::Vehicle& vehicle, const CostParams& params)
{
  worst_.clear();
  for (size_t i = 0; i < maps_.size(); ++i)
  {
    const GroundSlope slope(layersOf(maps_[i]), vehicle, params);
    if (!slope.isTold())
    {
      continue;
    }
    worst_.resize(prices_.size(), 0);
    const auto columns = static_cast<size_t>(layersOf(maps_[i]).extent.width());
    overlaps_[i].forEachRun(
        [&](size_t theirs, size_t ours, size_t length)
        {
          slope.raise(
              static_cast<int32_t>(theirs % columns), static_cast<int32_t>(theirs / columns),
              length, &worst_[ours]);
        });
  }
  for (size_t i = 0; i < worst_.size(); ++i)
  {
    prices_[i] += worst_[i];
  }
}
}  // namespace traverse::navigation
