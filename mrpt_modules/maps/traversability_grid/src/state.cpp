// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sensor_bits.h"

#include <traverse/traversability_grid/state.h>

#include <algorithm>
#include <cmath>

namespace traverse::traversability_grid
{
namespace
{
constexpr size_t kBytesPerMb = 1'000'000;

int64_t millimetres(double metres)
{
  return geometry::toMillimetres(metres);
}

/** Where the scan's cells are stored; those that find no tile leave the scan's. */
void obtainPlaces(State& state, size_t most_tiles, layers::UpdateStats& stats)
{
  std::vector<bool> is_refused;
  state.touched.clear();
  for (uint32_t number = 0; number < state.scan.size(); ++number)
  {
    const auto place = state.cells.obtain(state.scan.cell(number), most_tiles);
    if (place)
    {
      state.touched.push_back(*place);
      continue;
    }
    is_refused.resize(state.scan.size());
    is_refused[number] = true;
    state.scan.forEachSlab(number, [&](const ScanSlab& s) { stats.over_budget += s.n(); });
  }
  if (!is_refused.empty())
  {
    state.scan.remove(is_refused);
  }
}

/** False where there was room for none of them. */
bool addSums(
    State& state,
    uint32_t number,
    Cell& cell,
    const ScanSource& source,
    bool forgetting,
    layers::UpdateStats& stats)
{
  const bool is_new = cell.slabs == layers::HeightSlabs::kNone;
  uint64_t added = 0;
  state.scan.forEachSlab(
      number,
      [&](const ScanSlab& points)
      {
        layers::HeightSlab* slab = state.slabs.obtain(cell.slabs, points.level);
        if (slab == nullptr || points.n() > layers::HeightSlab::kMostPoints - slab->n)
        {
          stats.over_budget += points.n();
          return;
        }
        const layers::HeightSlab sums = source.sumsOf(points, state.lattice.cell_mm, state.slab_mm);
        slab->add(sums);
        if (forgetting)
        {
          addYoung(state, state.scan.cell(number), sums);
        }
        added += points.n();
      });
  stats.points += added;
  state.occupied += static_cast<size_t>(is_new && added > 0);
  return added > 0;
}

void dropCells(State& state)
{
  state.cells.clear();
  state.slabs.clear();
  state.memory = {};
  state.occupied = 0;
}

void leaveOut(State& state, const std::vector<bool>& is_gone)
{
  state.scan.remove(is_gone);
  size_t i = 0;
  std::erase_if(state.touched, [&](const Cells::Place&) { return is_gone[i++]; });
}
}  // namespace

void clearCell(State& state, Cell& cell)
{
  if (cell.slabs != layers::HeightSlabs::kNone)
  {
    state.slabs.release(cell.slabs);
    --state.occupied;
  }
  cell = Cell{};
}

ClassRule classRule(const Params& params, const geometry::Vehicle& vehicle)
{
  ClassRule rule;
  rule.params.classifier = params.classifier;
  rule.params.min_points = params.min_points;
  rule.params.ignore_overhangs = params.ignore_overhangs;
  rule.params.flat = params.flat;
  rule.params.small_roughness = params.small_roughness;
  rule.params.large_roughness = params.large_roughness;
  rule.params.index_flat = params.index_flat;
  rule.params.index_small_roughness = params.index_small_roughness;
  rule.params.index_large_roughness = params.index_large_roughness;
  rule.params.ground = params.ground;
  rule.clearance_mm = millimetres(vehicle.height_m);
  rule.max_step_m = vehicle.max_step_m;
  rule.max_slope_deg = vehicle.max_slope_deg;
  return rule;
}

Division divisionOf(const Params& params, const geometry::Vehicle& vehicle)
{
  check(params);
  options::check(vehicle);
  return {
      {static_cast<int32_t>(millimetres(params.cell_size_m))},
      static_cast<int32_t>(
          std::min(millimetres(params.slab_height_m), millimetres(vehicle.height_m)))};
}

State makeState(const Params& params, const geometry::Vehicle& vehicle)
{
  const Division division = divisionOf(params, vehicle);
  State state;
  state.lattice = division.lattice;
  state.slab_mm = division.slab_mm;
  state.slabs.setMost(mostSlabs(params));
  state.rule = classRule(params, vehicle);
  return state;
}

size_t mostTiles(const Params& params)
{
  return std::max<size_t>(
      1, static_cast<size_t>(params.max_memory_mb) * kBytesPerMb / 4 / Cells::kTileBytes);
}

size_t mostSlabs(const Params& params)
{
  return static_cast<size_t>(params.max_memory_mb) * kBytesPerMb / 4 * 3 /
         sizeof(layers::HeightSlab);
}

SlabReading slabReading(const State& state, const Params& params, const geometry::Vehicle& vehicle)
{
  // Where rings leave points almost on one line: the spec's figure.
  constexpr double kThin_mm = 30;
  SlabReading reading;
  reading.slab_mm = state.slab_mm;
  reading.clearance_mm = millimetres(vehicle.height_m);
  reading.ignore_overhangs = params.ignore_overhangs;
  reading.thin_mm = params.classifier == ClassifierKind::standard ? kThin_mm : 0;
  return reading;
}

void addToMap(
    State& state, const ScanSource& source, const Params& params, layers::UpdateStats& stats)
{
  const bool forgetting = forgets(params);
  obtainPlaces(state, mostTiles(params), stats);
  std::vector<bool> is_refused;
  forEachTouched(
      state,
      [&](uint32_t number, Cell& cell)
      {
        if (forgetting)
        {
          renew(state, state.scan.cell(number), cell, source.stamp(), params);
        }
        if (!addSums(state, number, cell, source, forgetting, stats))
        {
          is_refused.resize(state.touched.size());
          is_refused[number] = true;
        }
      });
  if (!is_refused.empty())
  {
    leaveOut(state, is_refused);
  }
  if (forgetting)
  {
    watchTiles(state, source.stamp(), params);
  }
}

void clearCells(State& state)
{
  if (state.touched.size() == state.occupied && state.memory.young.tiles() == 0)
  {
    forEachTouched(state, [&](uint32_t /*number*/, Cell& cell) { clearCell(state, cell); });
  }
  else
  {
    dropCells(state);
  }
  state.touched.clear();
  state.driven.clear();
}

void moveWindow(State& state, const geometry::CellRect& window)
{
  const std::optional<geometry::CellRect> old = std::exchange(state.window, window);
  if (!old || *old == window)
  {
    return;
  }
  state.driven.keep(window, state.lattice);
  const geometry::CellRect kept = geometry::intersection(*old, window);
  if (kept.empty())
  {
    dropCells(state);
    return;
  }
  const std::array<geometry::CellRect, 4> gone = {
      geometry::CellRect{old->min, {old->max.x, kept.min.y}},
      geometry::CellRect{{old->min.x, kept.max.y}, old->max},
      geometry::CellRect{{old->min.x, kept.min.y}, {kept.min.x, kept.max.y}},
      geometry::CellRect{{kept.max.x, kept.min.y}, {old->max.x, kept.max.y}}};
  for (const geometry::CellRect& strip : gone)
  {
    state.cells.forEachIn(
        strip, [&](Cells::Place place) { clearCell(state, state.cells.at(place)); });
  }
  for (const geometry::CellRect& strip : gone)  // a tile may lie in two of them
  {
    state.cells.releaseTiles(strip, window);
  }
  clearYoung(state, gone, window);
}

geometry::CellRect occupiedRect(const State& state)
{
  geometry::CellRect rect;
  forEachOccupied(
      state,
      [&](Cells::Place place, const Cell& /*cell*/)
      {
        const geometry::CellIndex c = state.cells.indexOf(place);
        rect = geometry::bounding(rect, {c, {c.x + 1, c.y + 1}});
      });
  return rect;
}

void reclassify(State& state, const Params& params, const geometry::Vehicle& vehicle)
{
  judgeAll(
      state, params, vehicle, occupiedRect(state),
      [&](Cells::Place place, const Judgement& judgement)
      { setClass(state.cells.at(place), judgement, params); });
  state.rule = classRule(params, vehicle);
}

void setClass(Cell& cell, const Judgement& judgement, const Params& params)
{
  cell.of = judgement.of;
  cell.index = indexOf(judgement.of, params);
  cell.ground_m = judgement.ground_m;
}

uint32_t sensorBit(State& state, std::string_view label)
{
  const auto known = std::find(state.sensors.begin(), state.sensors.end(), label);
  const auto number = static_cast<size_t>(known - state.sensors.begin());
  if (known == state.sensors.end() && number < kMostSensors)
  {
    state.sensors.emplace_back(label);
  }
  return sensorBitOf(number);
}
}  // namespace traverse::traversability_grid
