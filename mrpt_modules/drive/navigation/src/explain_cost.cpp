// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "map_witness.h"
#include "outline.h"
#include "text.h"

#include <traverse/navigation/cost_rules.h>
#include <traverse/navigation/costmap.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

namespace traverse::navigation
{
namespace
{
using geometry::CellIndex;
using layers::Fact;

constexpr std::array<std::string_view, 5> kPassages = {
    "open", "unknown", "soft buffer", "hard buffer", "obstacle"};

/** Squared distance in cells from a cell to the nearest obstacle of the costmap, up to a reach. */
std::optional<int64_t> nearestObstacle(const Costmap& costmap, CellIndex c, int32_t reach)
{
  std::optional<int64_t> nearest;
  const geometry::CellRect around = geometry::intersection(
      {{c.x - reach, c.y - reach}, {c.x + reach + 1, c.y + reach + 1}}, costmap.extent);
  for (CellIndex o = around.min; o.y < around.max.y; ++o.y)
  {
    for (o.x = around.min.x; o.x < around.max.x; ++o.x)
    {
      const int64_t dx = int64_t{o.x} - c.x;
      const int64_t dy = int64_t{o.y} - c.y;
      if (costmap.passageAt(o) == Passage::obstacle)
      {
        nearest = std::min(nearest.value_or(dx * dx + dy * dy), dx * dx + dy * dy);
      }
    }
  }
  return nearest;
}

Fact bufferFact(
    const Costmap& costmap, CellIndex c, const geometry::Vehicle& vehicle, const CostParams& params)
{
  const double hard_m = hardBuffer_m(params, vehicle, costmap.lattice);
  const double soft_m = hard_m + params.soft_buffer_m;
  const std::string widths =
      "hard up to " + inShort(hard_m) + " m, soft up to " + inShort(soft_m) + " m";
  constexpr double kMostCells = 4096;  // a costmap has no more
  const auto reach =
      static_cast<int32_t>(std::min(std::ceil(soft_m / costmap.lattice.cell_m()), kMostCells));
  const std::optional<int64_t> squared = nearestObstacle(costmap, c, reach);
  const double away_m =
      std::sqrt(static_cast<double>(squared.value_or(0))) * costmap.lattice.cell_m();
  const Passage passage = costmap.passageAt(c);
  if (!squared || (away_m > soft_m && passage < Passage::soft))
  {
    return {"buffer", "none: no obstacle within " + inShort(soft_m) + " m"};
  }
  std::string text = "nearest obstacle " + inShort(away_m) + " m away: " + widths;
  if (passage == Passage::unknown && !costmap.is_unknown_planned)
  {
    text += "; the unknown has no buffer";
  }
  else if (passage < Passage::soft)
  {
    text += "; a strip is cut free where soft buffers meet";
  }
  return {"buffer", text};
}

Fact sumFact(const Costmap& costmap, CellIndex c, const CostParams& params)
{
  const size_t i = costmap.indexOf(c);
  const Passage passage = costmap.passage[i];
  std::string text(kPassages.at(static_cast<size_t>(passage)));
  if (passage == Passage::unknown)
  {
    text += costmap.is_unknown_planned
                ? " (price + " + inShort(params.unknown_price - kLeastPrice) + ")"
                : " (never planned through)";
  }
  if (passage >= Passage::soft)
  {
    text += " (price + " + inShort(params.soft_price - kLeastPrice) + ")";
  }
  text += ", " + inShort(costmap.price[i]) + " a metre";
  if (std::isfinite(costmap.speed_mps[i]))
  {
    text += ", at " + inShort(costmap.speed_mps[i]) + " m/s at most";
  }
  if (passage == Passage::obstacle)
  {
    const float height = costmap.obstacle_m[i];
    text += height == kFallsAway ? ", the ground falls away"
            : std::isnan(height) ? ", height not known"
                                 : ", " + inShort(height) + " m high";
  }
  return {"sum", text};
}

/** What standing there says of a cell; nothing where the vehicle stands elsewhere. */
std::optional<Fact> vehicleFact(
    const Costmap& costmap, CellIndex c, const geometry::Vehicle& vehicle)
{
  const Outline outline(vehicle, costmap.stand);
  if (!outline.containsMiddle(costmap.lattice, c))
  {
    return std::nullopt;
  }
  if (costmap.passageAt(c) != Passage::obstacle)
  {
    return Fact{"vehicle", "stands there: open where no map knows better"};
  }
  return Fact{
      "vehicle", outline.containsAll(costmap.lattice, c)
                     ? "stands over all of it: the obstacle is false, or hit already"
                     : "stands over a part of it"};
}
}  // namespace

std::vector<Fact> explainCost(
    std::span<const MapLayers> maps,
    const Costmap& costmap,
    double x_m,
    double y_m,
    const geometry::Vehicle& vehicle,
    const CostParams& params)
{
  constexpr double kFarthest_m = 1e6;  // as ScanConsumer::explain()
  if (!(std::abs(x_m) <= kFarthest_m && std::abs(y_m) <= kFarthest_m))
  {
    return {{"sum", "outside of the costmap"}};
  }
  const CellIndex c = costmap.cellAt(x_m, y_m);
  std::vector<Fact> facts = {
      {"cell", std::to_string(c.x) + ", " + std::to_string(c.y) + " of " +
                   inShort(costmap.lattice.cell_m()) + " m"}};
  if (!costmap.extent.contains(c))
  {
    facts.push_back({"sum", "outside of the costmap"});
    return facts;
  }
  for (const MapLayers& map : maps)
  {
    if (map.set == nullptr)
    {
      facts.push_back({map.name, "has no layers"});
      continue;
    }
    const MapWitness witness(map, costmap, c);
    for (const LayerRule& rule : layerRules())
    {
      witness.tell(rule, vehicle, params, facts);
    }
    witness.tellSlope(vehicle, params, facts);
    witness.tellFriction(params, facts);
  }
  if (const std::optional<Fact> stand = vehicleFact(costmap, c, vehicle))
  {
    facts.push_back(*stand);
  }
  facts.push_back(bufferFact(costmap, c, vehicle, params));
  facts.push_back(sumFact(costmap, c, params));
  return facts;
}
}  // namespace traverse::navigation
