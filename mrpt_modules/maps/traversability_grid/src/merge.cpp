// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/traversability_grid/traversability_grid.h>

#include <limits>
#include <optional>
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
  other.cells.forEach(
      [&](Cells::Place place)
      {
        const Cell& from = other.cells.at(place);
        if (from.slabs == layers::HeightSlabs::kNone)
        {
          return;
        }
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

/** Sensor bits of the other map as this map counts them. */
uint32_t translated(uint32_t seen_by, const std::vector<uint32_t>& bits)
{
  constexpr uint32_t kOthers = uint32_t{1} << 31U;
  uint32_t out = seen_by & kOthers;
  for (size_t i = 0; i < bits.size(); ++i)
  {
    out |= ((seen_by >> i) & 1U) != 0 ? bits[i] : 0;
  }
  return out;
}

/** There is room for it. */
void addCell(
    State& state, const State& other, Cells::Place place, const std::vector<uint32_t>& bits)
{
  const Cell& from = other.cells.at(place);
  if (from.slabs == layers::HeightSlabs::kNone)
  {
    return;
  }
  const auto into =
      state.cells.obtain(other.cells.indexOf(place), std::numeric_limits<size_t>::max());
  Cell& cell = state.cells.at(*into);
  state.occupied += static_cast<size_t>(cell.slabs == layers::HeightSlabs::kNone);
  for (const auto* s = other.slabs.get(from.slabs); s != nullptr; s = other.slabs.get(s->next))
  {
    layers::HeightSlab slab = *s;
    slab.seen_by = translated(s->seen_by, bits);
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
  other.state.cells.forEach([&](Cells::Place place) { addCell(state, other.state, place, bits); });
  state.driven.add(other.state.driven);
  reclassify(state, params, vehicle);
}
}  // namespace traverse::traversability_grid
