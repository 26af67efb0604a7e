// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/lattice.h>
#include <traverse/geometry/vehicle.h>
#include <traverse/layers/layer_set.h>
#include <traverse/layers/occupancy_state.h>
#include <traverse/navigation/cost_params.h>

#include <limits>
#include <span>
#include <string_view>

// What the layers of maps mean to the navigator. A map is known by its layers' names alone:
//
//   layer                   value                   says
//   occupancy_state         0                       nothing
//                           1 free, 4 overhang      may be driven
//                           2 obstacle              obstacle, of a height that is not known
//                           3 negative              obstacle: the ground falls away (kFallsAway)
//   traversability_class    0                       nothing
//                           1 flat                  may be driven
//                           2 small roughness       may be driven, at small_roughness_mps at most
//                           3 large roughness       may be driven, at large_roughness_mps at most
//                           4 obstacle              obstacle, of height_max over ground_height
//   guaranteed_outline      not 0                   obstacle
//   traversability_index    0 .. 100                price + index_price * index / 100
//   ground_height           m                       price + slope_price * slope / max_slope_deg,
//                                                   slope_price at most; slope over 1.2 m
//   slope_deg               deg                     likewise, where ground_height is not known
//   friction                coefficient             highest accelerations; price + grip_price times
//                                                   (1 - friction / good_friction), 0 at least
//   friction_deviation      standard deviation      friction counts for less by friction_sigmas
//                                                   times it, 0.05 at least
//
// NaN says nothing, and so does a code that is not in the table. A slope alone is no obstacle, and
// that of a single cell is the last resort: it is fitted to few points of one or two rings, and
// flat road shows 15 deg and more (doc/maps/traversability_grid.md counts them). What is too steep
// to drive is the class's to say. safety_buffer of a map is not read: buffers are grown anew around
// all maps' obstacles.
namespace traverse::navigation
{
/** What one value of a layer says of its cell. */
struct CellSays
{
  layers::OccupancyState state = layers::OccupancyState::unknown;  //!< unknown: nothing of it
  float speed_mps = std::numeric_limits<float>::infinity();
};

/** A price that grows with a value up to a most. */
struct PriceRamp
{
  float per_unit = 0;
  float most = 0;

  /** 0 for NaN and below 0. */
  float at(float value) const
  {
    const float price = value * per_unit;
    return price > 0 ? (price < most ? price : most) : 0.0F;
  }
};

/** A row of the table: says what values are, or what they cost. */
struct LayerRule
{
  std::string_view layer;
  CellSays (*says)(double value, const CostParams&) = nullptr;
  PriceRamp (*ramp)(const geometry::Vehicle&, const CostParams&) = nullptr;
};

/** All rows but those of slopes and friction. */
std::span<const LayerRule> layerRules();

/** All layers that costmapOf() and explainCost() read. */
layers::LayerChoice costLayers();

/** The hard buffer in use, m, from the middle of an obstacle's cell: CostParams::hard_buffer_m, or
 * half of the footprint's width and half of a cell's diagonal, so that a round vehicle in the
 * middle of an open cell touches nothing wherever in its cell the obstacle is. */
double hardBuffer_m(
    const CostParams& params, const geometry::Vehicle& vehicle, const geometry::Lattice& lattice);
}  // namespace traverse::navigation
