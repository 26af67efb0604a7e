// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sensor_bits.h"

#include <traverse/traversability_grid/traversability_grid.h>

#include <limits>
#include <optional>
#include <span>
#include <stdexcept>

namespace traverse::traversability_grid
{
namespace
{
/** What a map lacks to take another one in. */
struct Need
{
  size_t tiles = 0;
  size_t slabs = 0;
};

/** Slabs of `from` that the list at `head` has not; both are sorted by level. */
size_t missingSlabs(const State& state, int32_t head, const State& other, int32_t from)
{
  size_t missing = 0;
  const layers::HeightSlab* there = state.slabs.get(head);
  for (const auto* s = other.slabs.get(from); s != nullptr; s = other.slabs.get(s->next))
  {
    while (there != nullptr && there->level < s->level)
    {
      there = state.slabs.get(there->next);
    }
    const bool known = there != nullptr && there->level == s->level;
    missing += static_cast<size_t>(!known);
    if (known && layers::HeightSlab::kMostPoints - there->n < s->n)
    {
      throw std::length_error("a cell of the merged map has more points than can be counted");
    }
  }
  return missing;
}

Need needOf(const State& state, const State& other)
{
  Need need;
  std::optional<uint32_t> missing_tile;
  forEachOccupied(
      other,
      [&](Cells::Place place, const Cell& from)
      {
        const auto into = state.cells.find(other.cells.indexOf(place));
        if (!into && missing_tile != place.tile)  // cells come tile by tile
        {
          missing_tile = place.tile;
          ++need.tiles;
        }
        const int32_t head = into ? state.cells.at(*into).slabs : layers::HeightSlabs::kNone;
        need.slabs += missingSlabs(state, head, other, from.slabs);
      });
  return need;
}

/** There is room for it. */
void addCell(
    State& state,
    geometry::CellIndex index,
    const State& other,
    const Cell& from,
    std::span<const uint32_t> bits)
{
  const auto into = state.cells.obtain(index, std::numeric_limits<size_t>::max());
  Cell& cell = state.cells.at(*into);
  state.occupied += static_cast<size_t>(cell.slabs == layers::HeightSlabs::kNone);
  for (const auto* s = other.slabs.get(from.slabs); s != nullptr; s = other.slabs.get(s->next))
  {
    layers::HeightSlab slab = *s;
    slab.seen_by = renumbered(s->seen_by, bits);
    state.slabs.obtain(cell.slabs, s->level)->add(slab);
  }
}
}  // namespace

std::string mergeObstacle(const Params& params)
{
  if (params.mode != Mode::accumulated)
  {
    return "mode = single_cloud keeps the last cloud only; use mode = accumulated";
  }
  if (params.extent == Extent::rolling)
  {
    return "extent = rolling forgets what the robot leaves behind; use extent = growing or fixed";
  }
  if (forgets(params))
  {
    return "forget_after_s and forget_after_points forget by time and order; use 0";
  }
  return "";
}

void merge(State& state, const Params& params, const geometry::Vehicle& vehicle, const Map& other)
{
  const std::string obstacle = mergeObstacle(params);
  if (!obstacle.empty() || !(params == other.params) || !(vehicle == other.vehicle))
  {
    throw std::invalid_argument(
        obstacle.empty() ? "a map made with other options or another vehicle" : obstacle);
  }
  const Need need = needOf(state, other.state);
  if (state.cells.tiles() + need.tiles > mostTiles(params) ||
      state.slabs.size() + need.slabs > mostSlabs(params))
  {
    throw std::length_error("the merged map has no room in max_memory_mb");
  }
  std::vector<uint32_t> bits;
  for (const std::string& label : other.state.sensors)
  {
    bits.push_back(sensorBit(state, label));
  }
  forEachOccupied(
      other.state, [&](Cells::Place place, const Cell& from)
      { addCell(state, other.state.cells.indexOf(place), other.state, from, bits); });
  state.driven.add(other.state.driven);
  reclassify(state, params, vehicle);
}
}  // namespace traverse::traversability_grid
