// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "overlap.h"

#include <traverse/geometry/vehicle.h>
#include <traverse/navigation/cost_rules.h>
#include <traverse/navigation/costmap.h>

#include <vector>

namespace traverse::navigation
{
/** Adds what the layers of one map say of one cell. */
class MapWitness
{
 public:
  MapWitness(const MapLayers& map, const Costmap& costmap, geometry::CellIndex c) :
      map_(map), overlap_(*map.set, costmap.lattice, {c, {c.x + 1, c.y + 1}})
  {
  }

  /** Of several cells of the map the worst counts: the last of those that say most. */
  void tell(
      const LayerRule& rule,
      const geometry::Vehicle& vehicle,
      const CostParams& params,
      std::vector<layers::Fact>& facts) const;

  /** Of several cells of the map the steepest. */
  void tellSlope(
      const geometry::Vehicle& vehicle,
      const CostParams& params,
      std::vector<layers::Fact>& facts) const;

  /** Of several cells of the map the slipperiest. */
  void tellFriction(const CostParams& params, std::vector<layers::Fact>& facts) const;

 private:
  const MapLayers& map_;
  Overlap overlap_;
};
}  // namespace traverse::navigation
