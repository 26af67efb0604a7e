// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/traversability_grid/forgetting.h>
#include <traverse/traversability_grid/state.h>

#include <algorithm>
#include <limits>

namespace traverse::traversability_grid
{
namespace
{
using layers::HeightSlabs;

constexpr double kNsPerS = 1e9;
constexpr poses::TimeNs kNever = std::numeric_limits<poses::TimeNs>::max();

/** Tiles are looked through no more often than this part of the age. */
constexpr poses::TimeNs kLooks = 8;

poses::TimeNs ageOf(const Params& params)
{
  return params.forget_after_s > 0 ? static_cast<poses::TimeNs>(params.forget_after_s * kNsPerS)
                                   : kNever;
}

poses::TimeNs lastSeen(const State& state, int32_t head)
{
  poses::TimeNs last = std::numeric_limits<poses::TimeNs>::min();
  for (const auto* s = state.slabs.get(head); s != nullptr; s = state.slabs.get(s->next))
  {
    last = std::max(last, s->last_seen);
  }
  return last;
}

uint64_t pointsOf(const State& state, int32_t head)
{
  uint64_t n = 0;
  for (const auto* s = state.slabs.get(head); s != nullptr; s = state.slabs.get(s->next))
  {
    n += s->n;
  }
  return n;
}

Memory::Young& youngOf(State& state, geometry::CellIndex index)
{
  // The map's own tiles are counted; these follow them.
  return state.memory.young.at(
      *state.memory.young.obtain(index, std::numeric_limits<size_t>::max()));
}

geometry::CellRect rectOf(const Memory::Tile& tile)
{
  return {{tile.second, tile.first}, {tile.second + Cells::kSide, tile.first + Cells::kSide}};
}

void schedule(State& state, const Memory::Tile& tile, poses::TimeNs when)
{
  state.memory.due[tile] = when;
  state.memory.next.emplace(when, tile);
}

void clear(State& state, Cells::Place place)
{
  Memory::Young& young = youngOf(state, state.cells.indexOf(place));
  state.slabs.release(young.slabs);
  young = {};
  clearCell(state, state.cells.at(place));
}

/** Looks through a tile; when it is to be looked through again, or kNever. */
poses::TimeNs lookThrough(
    State& state, const Memory::Tile& tile, poses::TimeNs now, poses::TimeNs age)
{
  poses::TimeNs oldest = kNever;
  forEachOccupiedIn(
      state, rectOf(tile),
      [&](Cells::Place place, const Cell& cell)
      {
        const poses::TimeNs last = lastSeen(state, cell.slabs);
        if (last < now - age)
        {
          clear(state, place);
          return;
        }
        oldest = std::min(oldest, last);
      });
  return oldest == kNever ? kNever : std::max(oldest + age, now + age / kLooks);
}
}  // namespace

bool forgets(const Params& params)
{
  return params.mode == Mode::accumulated &&
         (params.forget_after_s > 0 || params.forget_after_points > 0);
}

void renew(
    State& state, geometry::CellIndex index, Cell& cell, poses::TimeNs now, const Params& params)
{
  Memory::Young& young = youngOf(state, index);
  const poses::TimeNs age = ageOf(params);
  if (!young.is_begun)
  {
    young = {HeightSlabs::kNone, now, true};
    return;
  }
  const auto most = static_cast<uint64_t>(params.forget_after_points);
  const bool is_old = age != kNever && now - young.since >= age / 2;
  const bool is_much = most > 0 && pointsOf(state, young.slabs) >= (most + 1) / 2;
  if (!is_old && !is_much)
  {
    return;
  }
  if (age != kNever && young.slabs != HeightSlabs::kNone &&
      lastSeen(state, young.slabs) < now - age)
  {
    state.slabs.release(young.slabs);
  }
  const bool was_occupied = cell.slabs != HeightSlabs::kNone;
  state.slabs.release(cell.slabs);
  cell.slabs = young.slabs;
  state.occupied -= static_cast<size_t>(was_occupied && cell.slabs == HeightSlabs::kNone);
  young = {HeightSlabs::kNone, now, true};
}

void addYoung(State& state, geometry::CellIndex index, const layers::HeightSlab& points)
{
  layers::HeightSlab* slab = state.slabs.obtain(youngOf(state, index).slabs, points.level);
  if (slab != nullptr && points.n <= layers::HeightSlab::kMostPoints - slab->n)
  {
    slab->add(points);
  }
}

void watchTiles(State& state, poses::TimeNs now, const Params& params)
{
  const poses::TimeNs age = ageOf(params);
  if (age == kNever)
  {
    return;
  }
  state.scan.forEachTile(
      [&](geometry::CellIndex corner)
      {
        const Memory::Tile tile{corner.y, corner.x};
        if (!state.memory.due.contains(tile))
        {
          schedule(state, tile, now + age);
        }
      });
}

void forgetUnseen(State& state, poses::TimeNs now, const Params& params)
{
  const poses::TimeNs age = ageOf(params);
  Memory& memory = state.memory;
  while (!memory.next.empty() && std::get<0>(*memory.next.begin()) <= now)
  {
    const Memory::Tile tile = std::get<1>(*memory.next.begin());
    memory.next.erase(memory.next.begin());
    memory.due.erase(tile);
    const poses::TimeNs when = age == kNever ? kNever : lookThrough(state, tile, now, age);
    if (when != kNever)
    {
      schedule(state, tile, when);
    }
  }
}

void clearYoung(
    State& state, std::span<const geometry::CellRect> gone, const geometry::CellRect& kept)
{
  Memory& memory = state.memory;
  for (const geometry::CellRect& rect : gone)
  {
    memory.young.forEachIn(
        rect,
        [&](layers::TileGrid<Memory::Young>::Place place)
        {
          Memory::Young& young = memory.young.at(place);
          state.slabs.release(young.slabs);
          young = {};
        });
  }
  for (const geometry::CellRect& rect : gone)  // a tile may lie in two of them
  {
    memory.young.releaseTiles(rect, kept);
  }
  std::erase_if(
      memory.due,
      [&](const auto& entry)
      {
        const auto& [tile, when] = entry;
        const bool is_gone = geometry::intersection(rectOf(tile), kept).empty();
        return is_gone && memory.next.erase({when, tile}) > 0;
      });
}
}  // namespace traverse::traversability_grid
