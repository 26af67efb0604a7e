// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "strip.h"

#include <traverse/layers/distance_transform.h>
#include <traverse/layers/safety_buffer.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace traverse::layers
{
namespace
{

constexpr int64_t kReach_cells = DistanceTransform::kLongestReach_cells;

int64_t micrometres(double m)
{
  constexpr double kMost_m = 1e3;
  if (!(m >= 0 && m <= kMost_m))
  {
    throw std::invalid_argument("widths of a safety buffer are 0 to 1000 m");
  }
  return std::llround(m * 1e6);
}

/** The greatest squared distance in cells that is within a width; in integers, so that a width of
 * 15 cells reaches the 15th. Micrometres. */
int32_t squaredCells(int64_t width, int64_t cell)
{
  if (cell == 0 || width / cell >= kReach_cells)
  {
    throw std::invalid_argument("a safety buffer reaches 16382 cells at most");
  }
  return static_cast<int32_t>(width * width / (cell * cell));
}

std::vector<uint8_t> obstaclesOf(std::span<const uint8_t> states)
{
  std::vector<uint8_t> is_obstacle(states.size());
  uint8_t* const out = is_obstacle.data();
  for (size_t i = 0; i < states.size(); ++i)
  {
    const bool is_one = states[i] == static_cast<uint8_t>(OccupancyState::obstacle) ||
                        states[i] == static_cast<uint8_t>(OccupancyState::negative);
    out[i] = is_one ? 1 : 0;
  }
  return is_obstacle;
}

struct Limits
{
  int32_t hard_squared;
  int32_t soft_squared;
};

void setZones(
    std::span<const uint8_t> states,
    const NearestRow& nearest,
    const Limits& limits,
    std::span<uint8_t> zones)
{
  uint8_t* const zone_of = zones.data();  // bytes: not known to the compiler not to be the rest
  const int32_t* const squared_of = nearest.squared.data();
  const Limits limit = limits;
  const size_t columns = zones.size();
  for (size_t x = 0; x < columns; ++x)
  {
    const int32_t squared = squared_of[x];
    const BufferZone outer = squared <= limit.soft_squared ? BufferZone::soft : BufferZone::none;
    const BufferZone zone = squared <= limit.hard_squared ? BufferZone::hard : outer;
    const bool is_known = states[x] != static_cast<uint8_t>(OccupancyState::unknown);
    zone_of[x] = is_known ? static_cast<uint8_t>(zone) : uint8_t{0};
  }
}
}  // namespace

std::vector<uint8_t> safetyBuffer(
    std::span<const uint8_t> states, int32_t columns, const BufferParams& params)
{
  const int64_t hard = micrometres(params.hard_m);
  const int64_t cell = micrometres(params.cell_size_m);
  const Limits limits = {
      squaredCells(hard, cell), squaredCells(hard + micrometres(params.soft_m), cell)};
  DistanceTransform transform(obstaclesOf(states), columns, limits.soft_squared);
  std::vector<uint8_t> zones(states.size());
  const auto width = static_cast<size_t>(columns);
  const Buffer buffer = {states, zones, width};
  Strip strip(buffer, limits.hard_squared);
  std::vector<uint8_t> is_hard;  // of all cells, for strip = paper
  NearestRow now;
  NearestRow before;
  for (size_t y = 0; y * width < states.size(); ++y)
  {
    transform.row(static_cast<int32_t>(y), now);
    setZones(states.subspan(y * width, width), now, limits, buffer.zones.subspan(y * width, width));
    if (params.strip == StripRule::standard)
    {
      strip.addRow(y, now, before);
    }
    else if (params.strip == StripRule::paper)
    {
      std::transform(
          now.squared.begin(), now.squared.end(), std::back_inserter(is_hard),
          [&](int32_t squared)
          { return squared <= limits.hard_squared ? uint8_t{1} : uint8_t{0}; });
    }
    std::swap(now, before);
  }
  if (params.strip == StripRule::standard)
  {
    strip.finish();
  }
  else if (params.strip == StripRule::paper)
  {
    cutByLaplacian(
        buffer, is_hard, static_cast<int32_t>(std::ceil(params.soft_m / params.cell_size_m)));
  }
  return zones;
}
}  // namespace traverse::layers
