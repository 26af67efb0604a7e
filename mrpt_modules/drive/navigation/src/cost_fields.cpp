// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cost_fields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>
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

template <class Value>
const std::vector<Value>* dataOf(const LayerSet& set, std::string_view name)
{
  const Layer* layer = set.find(name);
  return layer == nullptr ? nullptr : std::get_if<std::vector<Value>>(&layer->data);
}

/** f(costmap's cell, what the map's cell says). Rules are asked once for each code, where there are
 * codes. */
template <class F>
void forEachSaid(const Layer& layer, const Overlap& overlap, F&& says, auto&& f)
{
  std::visit(
      [&](const auto& data)
      {
        using Value = typename std::remove_cvref_t<decltype(data)>::value_type;
        if constexpr (std::is_same_v<Value, uint8_t>)
        {
          std::array<CellSays, kCodes> table;
          for (size_t code = 0; code < kCodes; ++code)
          {
            table[code] = says(static_cast<double>(code));
          }
          overlap.forEach([&](size_t theirs, size_t ours) { f(ours, table[data[theirs]]); });
        }
        else
        {
          overlap.forEach([&](size_t theirs, size_t ours)
                          { f(ours, says(static_cast<double>(data[theirs]))); });
        }
      },
      layer.data);
}
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
  constexpr uint8_t kObstacle = 4;
  if (!areKnown() || (*classes_)[cell] != kObstacle)
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
    maps_(maps), vehicle_(vehicle), params_(params)
{
  const auto size =
      static_cast<size_t>(frame.extent.width()) * static_cast<size_t>(frame.extent.height());
  states_.resize(size, 0);
  prices_.resize(size, kLeastPrice);
  speeds_.resize(size, std::numeric_limits<float>::infinity());
  heights_.resize(size, kNan);
  for (const MapLayers& map : maps_)
  {
    overlaps_.emplace_back(map.set != nullptr ? *map.set : LayerSet{}, frame.lattice, frame.extent);
  }
  for (const LayerRule& rule : layerRules())
  {
    if (rule.is_price)
    {
      addPrices(rule);
      continue;
    }
    for (size_t i = 0; i < maps_.size(); ++i)
    {
      const Layer* layer = maps_[i].set != nullptr ? maps_[i].set->find(rule.layer) : nullptr;
      if (layer != nullptr)
      {
        readStates(*layer, overlaps_[i], rule);
      }
    }
  }
  for (size_t i = 0; i < maps_.size(); ++i)
  {
    if (maps_[i].set != nullptr)
    {
      readHeights(*maps_[i].set, overlaps_[i]);
    }
  }
}

void CostFields::readStates(const Layer& layer, const Overlap& overlap, const LayerRule& rule)
{
  uint8_t* const states = states_.data();
  float* const speeds = speeds_.data();
  forEachSaid(
      layer, overlap, [&](double value) { return rule.says(value, vehicle_, params_); },
      [&](size_t cell, const CellSays& said)
      {
        states[cell] = std::max(states[cell], static_cast<uint8_t>(said.state));
        speeds[cell] = std::min(speeds[cell], said.speed_mps);
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
          const float height = heights.at(theirs);
          if (!(height <= heights_[ours]) && !std::isnan(height))
          {
            heights_[ours] = height;
          }
        });
  }
  const Layer* const occupancy = set.find("occupancy_state");
  const auto* const codes =
      occupancy != nullptr ? std::get_if<std::vector<uint8_t>>(&occupancy->data) : nullptr;
  if (codes != nullptr)
  {
    overlap.forEach(
        [&](size_t theirs, size_t ours)
        {
          if ((*codes)[theirs] == static_cast<uint8_t>(OccupancyState::negative) &&
              std::isnan(heights_[ours]))
          {
            heights_[ours] = kFallsAway;
          }
        });
  }
}

void CostFields::addPrices(const LayerRule& rule)
{
  worst_.clear();
  for (size_t i = 0; i < maps_.size(); ++i)
  {
    const Layer* layer = maps_[i].set != nullptr ? maps_[i].set->find(rule.layer) : nullptr;
    if (layer == nullptr)
    {
      continue;
    }
    worst_.resize(prices_.size(), 0);
    float* const worst = worst_.data();
    forEachSaid(
        *layer, overlaps_[i], [&](double value) { return rule.says(value, vehicle_, params_); },
        [&](size_t cell, const CellSays& said)
        { worst[cell] = std::max(worst[cell], said.price); });
  }
  for (size_t i = 0; i < worst_.size(); ++i)
  {
    prices_[i] += worst_[i];
  }
}
}  // namespace traverse::navigation
