// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/lattice.h>
#include <traverse/geometry/pose2.h>
#include <traverse/geometry/vehicle.h>
#include <traverse/layers/layer_set.h>
#include <traverse/layers/scan_consumer.h>
#include <traverse/navigation/cost_params.h>

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace traverse::navigation
{
/** What a cell is to the vehicle's middle. The order is that of hindrance. */
enum class Passage : uint8_t
{
  open = 0,      //!< may be planned and driven through
  unknown = 1,   //!< no map saw it; CostParams::unknown says what that means
  soft = 2,      //!< may be driven, is not planned through
  hard = 3,      //!< the vehicle would touch an obstacle
  obstacle = 4,  //!< something stands there, or the ground falls away
};

/** Price of a metre over flat, known, open ground. Prices are never less, and finite. */
inline constexpr float kLeastPrice = 1.0F;

/** The ground falls away there: obstacle_m of such cells. */
inline constexpr float kFallsAway = -1.0F;

/** What driving over each cell of a window costs; rows along x from the cell of least x and y. */
struct Costmap
{
  geometry::Lattice lattice;
  geometry::CellRect extent;
  geometry::Pose2 stand;  //!< where the vehicle stood
  std::vector<Passage> passage;
  std::vector<float> price;      //!< of a metre, >= kLeastPrice; also where nothing may drive
  std::vector<float> speed_mps;  //!< highest speed that the ground allows; infinity: no limit
  std::vector<float>
      obstacle_m;               //!< what stands there over the ground, m; NaN: nothing or not known
  std::vector<float> friction;  //!< coefficient that maps are sure of; NaN, or empty: none knows it
  std::vector<geometry::CellIndex> strip;  //!< cells cut out of soft buffers that meet
  bool is_unknown_planned = true;          //!< CostParams::unknown is not UnknownPolicy::never

  size_t size() const { return passage.size(); }

  /** Of a cell of the extent. */
  size_t indexOf(geometry::CellIndex c) const
  {
    return static_cast<size_t>(c.y - extent.min.y) * static_cast<size_t>(extent.width()) +
           static_cast<size_t>(c.x - extent.min.x);
  }

  geometry::CellIndex cellAt(double x_m, double y_m) const
  {
    return lattice.cellOf(geometry::toMillimetres(x_m), geometry::toMillimetres(y_m));
  }

  /** NaN where no map knows it. */
  double frictionAt(geometry::CellIndex c) const
  {
    return !friction.empty() && extent.contains(c) ? static_cast<double>(friction[indexOf(c)])
                                                   : std::numeric_limits<double>::quiet_NaN();
  }

  /** unknown outside the extent. */
  Passage passageAt(geometry::CellIndex c) const
  {
    return extent.contains(c) ? passage[indexOf(c)] : Passage::unknown;
  }
};

/** One map's layers as they stand, and what the ini calls the map. */
struct MapLayers
{
  std::string name;
  const layers::LayerSet* set = nullptr;
};

/** Puts the layers of any maps together. Each layer is known by its name (cost_rules.h); a cell is
 * what the worst of its layers says, prices add up, speeds and friction are the lowest. Maps may
 * have cells of other sizes: a cell of the costmap counts all cells of theirs that overlap it.
 * Buffers are grown around the obstacles of all maps together (hardBuffer_m() of cost_rules.h); the
 * unknown has part in them where it may be planned through. What several maps say in layers of one
 * name counts once, the worst of it. Cells under the vehicle's own footprint, where it stands, that
 * no map saw are open. Cells that one map knows and another does not are known.
 *
 * Throws std::invalid_argument where the extent is empty or has more than 4096 cells along an edge,
 * a layer has not as many cells as its map, or buffers are out of layers::safetyBuffer's range. */
Costmap costmapOf(
    std::span<const MapLayers> maps,
    const geometry::Lattice& lattice,
    const geometry::CellRect& extent,
    const geometry::Pose2& stand,
    const geometry::Vehicle& vehicle,
    const CostParams& params);

/** What each layer of each map adds at a place, then the buffer, then the sum; key and value. */
std::vector<layers::Fact> explainCost(
    std::span<const MapLayers> maps,
    const Costmap& costmap,
    double x_m,
    double y_m,
    const geometry::Vehicle& vehicle,
    const CostParams& params);
}  // namespace traverse::navigation
