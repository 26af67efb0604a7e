// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "strip.h"

#include <traverse/layers/occupancy_state.h>

#include <algorithm>
#include <cmath>

namespace traverse::multi_lidar_grid
{
namespace
{
constexpr auto kNone = static_cast<uint8_t>(layers::BufferZone::none);
constexpr auto kSoft = static_cast<uint8_t>(layers::BufferZone::soft);
constexpr auto kHard = static_cast<uint8_t>(layers::BufferZone::hard);
constexpr auto kStrip = static_cast<uint8_t>(layers::BufferZone::strip);
constexpr auto kUnknown = static_cast<uint8_t>(layers::OccupancyState::unknown);
constexpr uint8_t kPerhaps = 255;  // soft, and between two obstacles; while this works

// Obstacle cells nearer to each other than this are one thing to any vehicle; their gap would be a
// matter of how a wall falls on the cells.
constexpr int32_t kLeastApart_cells = 3;

// Distances along the middle of a corridor go up and down by so much, as its walls fall on cells.
constexpr float kSlack_cells = 1;

}  // namespace

/** By 120 degrees or more: the cosine is at most -1/2. */
bool Strip::differ(const Side& a, const Side& b)
{
  const int64_t dot = int64_t{a.dx} * b.dx + int64_t{a.dy} * b.dy;
  return dot < 0 && 4 * dot * dot >= int64_t{a.squared} * b.squared;
}

Strip::Strip(const Buffer& buffer, int32_t hard_squared) :
    buffer_(buffer),
    least_apart_squared_(std::max(kLeastApart_cells * kLeastApart_cells, hard_squared)),
    wide_apart_squared_(std::max(kLeastApart_cells * kLeastApart_cells, 4 * hard_squared))
{
}

void Strip::mark(const Side& side, uint8_t zone)
{
  uint8_t& old = buffer_.zones[side.cell];
  if (old == kSoft || (old == kPerhaps && zone == kStrip))
  {
    old = zone;
    ridge_.push_back({side.cell, std::sqrt(static_cast<float>(side.squared))});
  }
}

/** b lies (step_x, step_y) from a. */
void Strip::addPair(const Side& a, const Side& b, int32_t step_x, int32_t step_y)
{
  if (a.squared == layers::NearestRow::kNone || b.squared == layers::NearestRow::kNone)
  {
    return;
  }
  const int64_t across = b.dx + step_x - a.dx;
  const int64_t along = b.dy + step_y - a.dy;
  const int64_t apart_squared = across * across + along * along;
  if (apart_squared < least_apart_squared_)
  {
    return;
  }
  if (differ(a, b) || apart_squared >= wide_apart_squared_)
  {
    const uint8_t zone = differ(a, b) ? kStrip : kPerhaps;
    mark(a, zone);
    mark(b, zone);
  }
}

void Strip::addRow(size_t y, const layers::NearestRow& now, const layers::NearestRow& before)
{
  const size_t begin = y * buffer_.columns;
  const auto isSoft = [&](size_t cell)
  { return buffer_.zones[cell] != kNone && buffer_.zones[cell] != kHard; };
  const auto side = [](const layers::NearestRow& row, size_t row_begin, size_t x) {
    return Side{row_begin + x, row.squared[x], row.dx[x], row.dy[x]};
  };
  for (size_t x = 0; x < buffer_.columns; ++x)
  {
    const size_t cell = begin + x;
    if (x > 0 && (isSoft(cell) || isSoft(cell - 1)))
    {
      addPair(side(now, begin, x - 1), side(now, begin, x), 1, 0);
    }
    if (y > 0 && (isSoft(cell) || isSoft(cell - buffer_.columns)))
    {
      addPair(side(before, begin - buffer_.columns, x), side(now, begin, x), 0, 1);
    }
  }
}

template <class F>
void Strip::forEachNeighbour(size_t cell, F&& f) const
{
  const size_t x = cell % buffer_.columns;
  if (cell >= buffer_.columns)
  {
    f(cell - buffer_.columns);
  }
  if (x > 0)
  {
    f(cell - 1);
  }
  if (x + 1 < buffer_.columns)
  {
    f(cell + 1);
  }
  if (cell + buffer_.columns < buffer_.zones.size())
  {
    f(cell + buffer_.columns);
  }
}

bool Strip::isBesideFree(size_t cell) const
{
  bool found = false;
  forEachNeighbour(
      cell, [&](size_t next)
      { found |= buffer_.zones[next] == kNone && buffer_.states[next] != kUnknown; });
  return found;
}

/** By cell; once each. */
void Strip::sortRidge()
{
  const auto before = [](const RidgeCell& a, const RidgeCell& b) { return a.cell < b.cell; };
  const auto same = [](const RidgeCell& a, const RidgeCell& b) { return a.cell == b.cell; };
  std::sort(ridge_.begin(), ridge_.end(), before);
  ridge_.erase(std::unique(ridge_.begin(), ridge_.end(), same), ridge_.end());
}

size_t Strip::ridgeAt(size_t cell) const
{
  const auto before = [](const RidgeCell& ridge, size_t key) { return ridge.cell < key; };
  return static_cast<size_t>(
      std::lower_bound(ridge_.begin(), ridge_.end(), cell, before) - ridge_.begin());
}

/** The way by which the search came becomes strip. */
void Strip::cutBackFrom(size_t at)
{
  for (; buffer_.zones[ridge_[at].cell] == kPerhaps; at = ridge_[at].from)
  {
    buffer_.zones[ridge_[at].cell] = kStrip;
  }
}

void Strip::leadOut()
{
  sortRidge();
  std::vector<size_t> reached;
  for (size_t i = 0; i < ridge_.size(); ++i)
  {
    if (buffer_.zones[ridge_[i].cell] == kStrip)
    {
      ridge_[i].farthest = ridge_[i].distance;
      reached.push_back(i);
    }
  }
  for (size_t next = 0; next < reached.size(); ++next)
  {
    const size_t at = reached[next];
    if (isBesideFree(ridge_[at].cell))
    {
      cutBackFrom(at);
      continue;
    }
    const float farthest = ridge_[at].farthest;
    forEachNeighbour(
        ridge_[at].cell,
        [&](size_t cell)
        {
          RidgeCell* const ridge =
              buffer_.zones[cell] == kPerhaps ? &ridge_[ridgeAt(cell)] : nullptr;
          if (ridge != nullptr && ridge->farthest == 0 &&
              ridge->distance >= farthest - kSlack_cells)
          {
            ridge->farthest = std::max(farthest, ridge->distance);
            ridge->from = at;
            reached.push_back(ridgeAt(cell));
          }
        });
  }
  for (const RidgeCell& ridge : ridge_)
  {
    uint8_t& zone = buffer_.zones[ridge.cell];
    zone = zone == kPerhaps ? kSoft : zone;
  }
}
}  // namespace traverse::multi_lidar_grid
