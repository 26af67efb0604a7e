// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "overlap.h"

#include <traverse/navigation/cost_rules.h>
#include <traverse/navigation/costmap.h>

#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace traverse::navigation
{
/** Where a costmap's cells lie. */
struct CostFrame
{
  geometry::Lattice lattice;
  geometry::CellRect extent;
};

/** What the layers of all maps say of the cells of a costmap; no buffers yet. */
class CostFields
{
 public:
  CostFields(
      std::span<const MapLayers> maps,
      const CostFrame& frame,
      const geometry::Vehicle& vehicle,
      const CostParams& params);

  /** Codes of layers::OccupancyState: unknown, free, obstacle or negative. */
  std::vector<uint8_t> takeStates() { return std::move(states_); }

  std::vector<float> takePrices() { return std::move(prices_); }

  std::vector<float> takeSpeeds() { return std::move(speeds_); }

  std::vector<float> takeHeights() { return std::move(heights_); }

  /** Empty where no map tells any. */
  std::vector<float> takeFriction() { return std::move(friction_); }

 private:
  /** A layer of one of the maps. */
  struct Source
  {
    const layers::Layer* layer;
    const Overlap* overlap;
  };

  std::vector<Source> sourcesOf(std::string_view layer) const;
  void readStates(const Source& source, const LayerRule& rule, const CostParams& params);
  void readHeights(const layers::LayerSet& set, const Overlap& overlap);
  void addSlopes(const geometry::Vehicle& vehicle, const CostParams& params);
  void addFriction(const CostParams& params);
  void addPrices(const std::vector<Source>& sources, const PriceRamp& ramp);

  std::span<const MapLayers> maps_;
  std::vector<Overlap> overlaps_;
  std::vector<uint8_t> states_;
  std::vector<float> prices_;
  std::vector<float> speeds_;
  std::vector<float> heights_;
  std::vector<float> friction_;
  std::vector<float> worst_;  //!< price of one rule, the worst of all maps
};

/** Heights over the ground of what stands in the cells of a map that has classes and heights. Ask
 * for cells where they are known only. */
class ObstacleHeights
{
 public:
  explicit ObstacleHeights(const layers::LayerSet& set);

  bool areKnown() const { return classes_ != nullptr && top_ != nullptr; }

  bool isObstacle(size_t cell) const { return (*classes_)[cell] == kObstacleClass; }

  /** m; NaN where it is not known, or no obstacle stands there. */
  float at(size_t cell) const;

 private:
  static constexpr uint8_t kObstacleClass = 4;

  const std::vector<uint8_t>* classes_;
  const std::vector<float>* top_;
  const std::vector<float>* bottom_;
  const std::vector<float>* ground_;
};
}  // namespace traverse::navigation
