// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/traversability_grid/state.h>

#include <algorithm>
#include <cmath>
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
  const int64_t patch =
      std::max<int64_t>(1, std::lround(params.ground.patch_m / state.lattice.cell_m()));
  const int64_t side = kBlockPatches * patch;
  const int64_t margin = kMarginPatches * patch;
  std::set<std::pair<int64_t, int64_t>> occupied;  // by row, then column
  state.cells.forEachIn(
      window,
      [&](Cells::Place place)
      {
        if (state.cells.at(place).slabs != layers::HeightSlabs::kNone)
        {
          const geometry::CellIndex c = state.cells.indexOf(place);
          occupied.emplace(geometry::floorDiv(c.y, side), geometry::floorDiv(c.x, side));
        }
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

Judge judgeBlock(
    const State& state,
    const Params& params,
    const geometry::Vehicle& vehicle,
    const Block& block,
    std::vector<Cells::Place>& places)
{
  SlabReading reading = slabReading(state, params, vehicle);
  const auto read = [&](Cells::Place place)
  { return featuresOf(state.slabs, state.slabs.get(state.cells.at(place).slabs), reading); };
  Judge judge;
  judge.begin(params, vehicle, state.lattice, block.judged, state.driven);
  state.cells.forEachIn(
      block.judged,
      [&](Cells::Place place)
      {
        if (state.cells.at(place).slabs != layers::HeightSlabs::kNone)
        {
          places.push_back(place);
          judge.add(state.cells.indexOf(place), read(place));
        }
      });
  judge.finish(
      [&](size_t i, int64_t floor_mm)
      {
        reading.floor_mm = floor_mm;
        return read(places[i]);
      });
  return judge;
}
}  // namespace traverse::traversability_grid
