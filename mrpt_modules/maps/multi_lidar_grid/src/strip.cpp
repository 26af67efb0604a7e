// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "strip.h"

#include <traverse/layers/occupancy_state.h>

#include <algorithm>
#include <cmath>
#include <limits>

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

// Where the buffers of two posts just touch, they do over 7 cells (of 15).
constexpr int32_t kLeastPassage_cells = 4;

/** Sides of the rectangle around some cells. */
class Extent
{
 public:
  void add(int32_t x, int32_t y)
  {
    min_x_ = std::min(min_x_, x);
    max_x_ = std::max(max_x_, x);
    min_y_ = std::min(min_y_, y);
    max_y_ = std::max(max_y_, y);
  }

  /** 0 for no cell. */
  int32_t longest() const
  {
    return min_x_ > max_x_ ? 0 : std::max(max_x_ - min_x_, max_y_ - min_y_) + 1;
  }

 private:
  int32_t min_x_ = std::numeric_limits<int32_t>::max();
  int32_t max_x_ = std::numeric_limits<int32_t>::min();
  int32_t min_y_ = std::numeric_limits<int32_t>::max();
  int32_t max_y_ = std::numeric_limits<int32_t>::min();
};

int64_t squared(int64_t v)
{
  return v * v;
}

/** Within 5/6 of a cell of the bisector of two obstacles, where the squared distances from them
 * differ by so much; a line's cells that touch by their sides are within 0.71. */
bool isOnBisector(int64_t difference, int64_t apart_squared)
{
  return 9 * squared(difference) <= 25 * apart_squared;
}
}  // namespace

bool Strip::isSoft(size_t cell) const
{
  return buffer_.zones[cell] != kNone && buffer_.zones[cell] != kHard;
}

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

/** By 120 degrees or more also if one obstacle is a cell nearer to the other than seems, as by how
 * walls fall on cells: so the obstacles' distance from each other, over those from here, is at
 * least twice the sine of 60 degrees. */
bool Strip::isClear(const Side& a, const Side& b, int64_t apart_squared)
{
  const auto root = [](int64_t v) { return std::sqrt(static_cast<float>(v)); };
  return root(apart_squared) - 1 >= 0.8660254F * (root(a.squared) + root(b.squared));
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
  const int64_t apart_squared = squared(b.dx + step_x - a.dx) + squared(b.dy + step_y - a.dy);
  if (apart_squared < least_apart_squared_)
  {
    return;
  }
  const bool is_strip = differ(a, b) && isClear(a, b, apart_squared);
  if (is_strip || apart_squared >= wide_apart_squared_)
  {
    const uint8_t zone = is_strip ? kStrip : kPerhaps;
    // Of both cells those through which the bisector of their obstacles passes, more or less.
    const int64_t off_a = squared(b.dx + step_x) + squared(b.dy + step_y) - a.squared;
    const int64_t off_b = squared(a.dx - step_x) + squared(a.dy - step_y) - b.squared;
    if (!is_strip || isOnBisector(off_a, apart_squared) || !isSoft(b.cell))
    {
      mark(a, zone);
    }
    if (!is_strip || isOnBisector(off_b, apart_squared) || !isSoft(a.cell))
    {
      mark(b, zone);
    }
  }
}

void Strip::addRow(size_t y, const layers::NearestRow& now, const layers::NearestRow& before)
{
  const size_t begin = y * buffer_.columns;
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

template <class F>
void Strip::forEachCorner(size_t cell, F&& f) const
{
  const size_t x = cell % buffer_.columns;
  const bool has_before = cell >= buffer_.columns;
  const bool has_after = cell + buffer_.columns < buffer_.zones.size();
  for (const bool left : {true, false})
  {
    const size_t side = left ? cell - 1 : cell + 1;
    const bool has_side = left ? x > 0 : x + 1 < buffer_.columns;
    if (has_side && has_before)
    {
      f(side - buffer_.columns);
    }
    if (has_side && has_after)
    {
      f(side + buffer_.columns);
    }
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

/** From the strips over what may be ridge, as long as it recedes from obstacles; where that ends in
 * the open, the way is strip. */
void Strip::leadOut()
{
  std::vector<size_t> reached;
  for (size_t i = 0; i < ridge_.size(); ++i)
  {
    if (buffer_.zones[ridge_[i].cell] == kStrip)
    {
      ridge_[i].is_seed = true;
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
    forEachNeighbour(
        ridge_[at].cell,
        [&](size_t cell)
        {
          const size_t to = buffer_.zones[cell] == kPerhaps ? ridgeAt(cell) : at;
          const float farthest = ridge_[at].farthest;
          if (ridge_[to].farthest == 0 && ridge_[to].distance >= farthest - kSlack_cells)
          {
            ridge_[to].farthest = std::max(farthest, ridge_[to].distance);
            ridge_[to].from = at;
            reached.push_back(to);
          }
        });
  }
}

/** All cells of one strip, by their sides and corners. */
std::vector<size_t> Strip::pieceFrom(size_t seed)
{
  std::vector<size_t> piece = {seed};
  ridge_[seed].is_counted = true;
  const auto add = [&](size_t cell)
  {
    if (buffer_.zones[cell] == kStrip && !ridge_[ridgeAt(cell)].is_counted)
    {
      piece.push_back(ridgeAt(cell));
      ridge_[piece.back()].is_counted = true;
    }
  };
  for (size_t next = 0; next < piece.size(); ++next)
  {
    const size_t cell = ridge_[piece[next]].cell;
    forEachNeighbour(cell, add);
    forEachCorner(cell, add);
  }
  return piece;
}

/** A strip is a way where it is longer than wide, or leads from the open to the open. Others are
 * dents of one obstacle. */
bool Strip::isWay(const std::vector<size_t>& piece) const
{
  Extent seeds;
  Extent exits;
  float distance = 0;
  for (const size_t at : piece)
  {
    const RidgeCell& ridge = ridge_[at];
    const auto x = static_cast<int32_t>(ridge.cell % buffer_.columns);
    const auto y = static_cast<int32_t>(ridge.cell / buffer_.columns);
    if (ridge.is_seed)
    {
      seeds.add(x, y);
      distance = std::max(distance, ridge.distance);
    }
    if (isBesideFree(ridge.cell))
    {
      exits.add(x, y);
    }
  }
  return static_cast<float>(seeds.longest()) >= 2 * distance ||
         exits.longest() >= kLeastPassage_cells;
}

void Strip::finish()
{
  sortRidge();
  leadOut();
  for (size_t i = 0; i < ridge_.size(); ++i)
  {
    uint8_t& zone = buffer_.zones[ridge_[i].cell];
    zone = zone == kPerhaps ? kSoft : zone;
  }
  for (size_t i = 0; i < ridge_.size(); ++i)
  {
    if (buffer_.zones[ridge_[i].cell] == kStrip && !ridge_[i].is_counted)
    {
      const std::vector<size_t> piece = pieceFrom(i);
      const uint8_t zone = isWay(piece) ? kStrip : kSoft;
      for (const size_t at : piece)
      {
        buffer_.zones[ridge_[at].cell] = zone;
      }
    }
  }
}
}  // namespace traverse::multi_lidar_grid
