// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/layers/safety_buffer.h>
#include <traverse/multi_lidar_grid/fusion.h>
#include <traverse/multi_lidar_grid/multi_lidar_grid.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace traverse::multi_lidar_grid
{
namespace
{
using layers::OccupancyState;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr uint8_t kFreeBySeveral = 5;

int64_t cellsOf(const geometry::CellRect& rect)
{
  const int64_t width = int64_t{rect.max.x} - rect.min.x;
  const int64_t height = int64_t{rect.max.y} - rect.min.y;
  if (width <= 0 || height <= 0)
  {
    return 0;
  }
  return width > kMostLayerCells || height > kMostLayerCells ? kMostLayerCells + 1 : width * height;
}

/** The colours of the paper's figures; ditches and what hangs over are not in them. */
std::vector<layers::LegendEntry> legend()
{
  return {
      {0, "unknown", {72, 72, 72}},
      {1, "free, seen by one sensor", {150, 150, 150}},
      {kFreeBySeveral, "free, seen by several", {222, 222, 222}},
      {2, "obstacle", {0, 0, 0}},
      {3, "negative obstacle", {214, 40, 40}},
      {4, "free under an overhang", {84, 160, 214}}};
}

size_t placeIn(const geometry::CellRect& rect, geometry::CellIndex c)
{
  return static_cast<size_t>(c.y - rect.min.y) * static_cast<size_t>(rect.width()) +
         static_cast<size_t>(c.x - rect.min.x);
}

/** The layers of the accumulated map while they are filled. */
struct Accumulated
{
  explicit Accumulated(size_t size) :
      state(size, 0),
      view(size, 0),
      seen_by(size, 0),
      free(size, kNan),
      ground(size, kNan),
      age(size, kNan)
  {
  }

  void put(size_t i, const Cell& cell, double ground_m, poses::TimeNs now)
  {
    const bool is_free = cell.state == OccupancyState::free;
    state[i] = static_cast<uint8_t>(cell.state);
    view[i] = is_free && std::popcount(cell.seen_by) > 1 ? kFreeBySeveral : state[i];
    seen_by[i] = cell.seen_by;
    ground[i] = static_cast<float>(ground_m);
    if (is_free || cell.state == OccupancyState::overhang)
    {
      free[i] = static_cast<float>(cell.up_to * kFreeStep_m);
    }
    if (cell.state != OccupancyState::unknown)
    {
      const double age_ns = static_cast<double>(now) - static_cast<double>(cell.last_seen);
      age[i] = static_cast<float>(age_ns * poses::kSecondsPerNs);
    }
  }

  std::vector<uint8_t> state, view;
  std::vector<uint32_t> seen_by;
  std::vector<float> free, ground, age;
};

geometry::CellRect grown(const geometry::CellRect& rect, int32_t by)
{
  const auto at = [](int64_t edge)
  {
    constexpr int64_t kLeast = std::numeric_limits<int32_t>::min();
    constexpr int64_t kMost = std::numeric_limits<int32_t>::max();
    return static_cast<int32_t>(std::clamp(edge, kLeast, kMost));
  };
  return {
      {at(int64_t{rect.min.x} - by), at(int64_t{rect.min.y} - by)},
      {at(int64_t{rect.max.x} + by), at(int64_t{rect.max.y} + by)}};
}

/** Obstacles beside the window reach into it; outside the region there are none. */
std::vector<uint8_t> bufferIn(
    const State& state,
    const Params& params,
    const geometry::Vehicle& vehicle,
    const geometry::CellRect& window)
{
  constexpr int32_t kNeighbours = 4;  // that the strip's rules look at
  std::vector<uint8_t> zones(
      static_cast<size_t>(window.width()) * static_cast<size_t>(window.height()), 0);
  const layers::BufferParams buffer{
      state.lattice.cell_m(), hardBuffer_m(params, vehicle), params.soft_buffer_m, params.strip};
  const double reach_cells = (buffer.hard_m + buffer.soft_m) / buffer.cell_size_m;
  const geometry::CellRect around = geometry::intersection(
      grown(window, static_cast<int32_t>(std::ceil(reach_cells)) + kNeighbours),
      state.cells.region());
  if (around.empty())
  {
    return zones;
  }
  std::vector<uint8_t> states;
  states.reserve(static_cast<size_t>(around.width()) * static_cast<size_t>(around.height()));
  state.cells.forEachIn(
      around, [&](geometry::CellIndex, const Cell& cell)
      { states.push_back(static_cast<uint8_t>(cell.state)); });
  const std::vector<uint8_t> found = layers::safetyBuffer(states, around.width(), buffer);
  const geometry::CellRect shown = geometry::intersection(window, around);
  for (geometry::CellIndex c = shown.min; c.y < shown.max.y; ++c.y)
  {
    for (c.x = shown.min.x; c.x < shown.max.x; ++c.x)
    {
      zones[placeIn(window, c)] = found[placeIn(around, c)];
    }
  }
  return zones;
}
}  // namespace

layers::LayerSet layerSet(
    const State& state,
    const Params& params,
    const geometry::Vehicle& vehicle,
    std::optional<geometry::CellRect> window,
    const layers::LayerChoice& wanted)
{
  layers::LayerSet set;
  set.lattice = state.lattice;
  set.extent = window ? *window : state.empty() ? geometry::CellRect{} : state.cells.region();
  const int64_t size = cellsOf(set.extent);
  if (size > kMostLayerCells)
  {
    throw std::length_error("the window has more than 100 million cells");
  }
  set.extent = size == 0 ? geometry::CellRect{} : set.extent;
  set.class_layer = "occupancy_view";
  set.legend = legend();
  set.blocked_codes = {
      static_cast<uint8_t>(OccupancyState::obstacle),
      static_cast<uint8_t>(OccupancyState::negative)};

  Accumulated all(static_cast<size_t>(size));
  state.cells.forEachIn(
      geometry::intersection(set.extent, state.cells.region()),
      [&](geometry::CellIndex c, const Cell& cell)
      { all.put(placeIn(set.extent, c), cell, state.mapper.groundAt(c), state.now); });
  set.layers.push_back({"occupancy_view", "1", std::move(all.view)});
  set.layers.push_back({"occupancy_state", "1", std::move(all.state)});
  set.layers.push_back({"sensor_mask", "1", std::move(all.seen_by)});
  if (wanted.has("occupancy_latest") || wanted.has("latest_mask"))
  {
    LatestMap latest = fuseLatest(state, params, set.extent);
    set.layers.push_back({"occupancy_latest", "1", std::move(latest.states)});
    set.layers.push_back({"latest_mask", "1", std::move(latest.seen_by)});
  }
  set.layers.push_back({"free_height", "m", std::move(all.free)});
  set.layers.push_back({"ground_height", "m", std::move(all.ground)});
  set.layers.push_back({"last_seen_age", "s", std::move(all.age)});
  if (wanted.has("safety_buffer"))
  {
    set.layers.push_back({"safety_buffer", "1", bufferIn(state, params, vehicle, set.extent)});
  }
  return set;
}
}  // namespace traverse::multi_lidar_grid
