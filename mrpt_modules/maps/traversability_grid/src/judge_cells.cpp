// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/traversability_grid/state.h>

#include <algorithm>
#include <set>

namespace traverse::traversability_grid
{
namespace
{
constexpr int64_t kBlockPatches = 1024;
constexpr int64_t kMarginPatches = 128;  // more than a sensor's reach, with patches of 1 m

geometry::CellRect within(const geometry::CellRect& window, int64_t x0, int64_t y0, int64_t side)
{
  const auto clamped = [](int64_t v, int32_t low, int32_t high)
  { return static_cast<int32_t>(std::clamp<int64_t>(v, low, high)); };
  return {
      {clamped(x0, window.min.x, window.max.x), clamped(y0, window.min.y, window.max.y)},
      {clamped(x0 + side, window.min.x, window.max.x),
       clamped(y0 + side, window.min.y, window.max.y)}};
}
}  // namespace

std::vector<Block> blocksOf(
    const State& state, const Params& params, const geometry::CellRect& window)
{
  const int64_t patch = ground::cellsAlongPatch(params.ground.patch_m, state.lattice);
  const int64_t side = kBlockPatches * patch;
  const int64_t margin = kMarginPatches * patch;
  std::set<std::pair<int64_t, int64_t>> occupied;  // by row, then column
  forEachOccupiedIn(
      state, window,
      [&](Cells::Place place, const Cell& /*cell*/)
      {
        const geometry::CellIndex c = state.cells.indexOf(place);
        occupied.emplace(geometry::floorDiv(c.y, side), geometry::floorDiv(c.x, side));
      });
  std::vector<Block> blocks;
  blocks.reserve(occupied.size());
  for (const auto& [row, column] : occupied)
  {
    blocks.push_back(
        {within(window, column * side, row * side, side),
         within(window, column * side - margin, row * side - margin, side + 2 * margin)});
  }
  return blocks;
}

void judgeCells(
    const State& state,
    std::span<const Cells::Place> places,
    const geometry::CellRect& window,
    const Params& params,
    const geometry::Vehicle& vehicle,
    Judge& judge)
{
  SlabReading reading = slabReading(state, params, vehicle);
  const auto read = [&](const Cell& cell)
  { return featuresOf(state.slabs, state.slabs.get(cell.slabs), reading); };
  judge.begin(params, vehicle, state.lattice, window, state.driven);
  forEachAt(
      state, places,
      [&](uint32_t number, const Cell& cell)
      { judge.add(state.cells.indexOf(places[number]), read(cell)); });  // step 4
  judge.finish(
      [&](size_t i, int64_t floor_mm)
      {
        reading.floor_mm = floor_mm;
        return read(state.cells.at(places[i]));
      });  // step 5
}
}  // namespace traverse::traversability_grid
