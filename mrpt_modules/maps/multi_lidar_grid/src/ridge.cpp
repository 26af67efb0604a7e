// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ridge.h"

#include <traverse/layers/occupancy_state.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace traverse::multi_lidar_grid
{
namespace
{
constexpr auto kNone = static_cast<uint8_t>(layers::BufferZone::none);
constexpr auto kSoft = static_cast<uint8_t>(layers::BufferZone::soft);
constexpr auto kHard = static_cast<uint8_t>(layers::BufferZone::hard);
constexpr auto kStrip = static_cast<uint8_t>(layers::BufferZone::strip);
constexpr auto kUnknown = static_cast<uint8_t>(layers::OccupancyState::unknown);
constexpr uint8_t kPerhaps = 255;  // soft, and may become strip

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

/** Which strips are one. */
class Joined
{
 public:
  explicit Joined(size_t labels) : parent_(labels)
  {
    std::iota(parent_.begin(), parent_.end(), uint32_t{0});
  }

  uint32_t find(uint32_t label)
  {
    while (parent_[label] != label)
    {
      label = parent_[label] = parent_[parent_[label]];
    }
    return label;
  }

  /** False where they were before. */
  bool join(uint32_t a, uint32_t b)
  {
    const uint32_t root = find(a);
    const bool is_new = root != find(b);
    parent_[root] = find(b);
    return is_new;
  }

 private:
  std::vector<uint32_t> parent_;
};
}  // namespace

bool Buffer::isSoft(size_t cell) const
{
  return zones[cell] != kNone && zones[cell] != kHard;
}

void Ridge::add(size_t cell, int32_t squared_distance, bool is_strip)
{
  uint8_t& zone = buffer_.zones[cell];
  if (zone == kSoft)
  {
    cells_.push_back({cell, std::sqrt(static_cast<float>(squared_distance))});
    zone = kPerhaps;
  }
  if (zone == kPerhaps && is_strip)
  {
    zone = kStrip;
  }
}

/** By cell, for at(). */
void Ridge::sort()
{
  std::sort(
      cells_.begin(), cells_.end(), [](const Cell& a, const Cell& b) { return a.cell < b.cell; });
  for (Cell& cell : cells_)
  {
    cell.is_seed = buffer_.zones[cell.cell] == kStrip;
  }
}

size_t Ridge::at(size_t cell) const
{
  const auto before = [](const Cell& ridge, size_t key) { return ridge.cell < key; };
  return static_cast<size_t>(
      std::lower_bound(cells_.begin(), cells_.end(), cell, before) - cells_.begin());
}

template <class F>
void Ridge::forEachNeighbour(size_t cell, F&& f) const
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

/** The neighbours across corners. */
template <class F>
void Ridge::forEachCorner(size_t cell, F&& f) const
{
  forEachNeighbour(
      cell,
      [&](size_t side)
      {
        const bool is_in_column = side + buffer_.columns == cell || side == cell + buffer_.columns;
        const size_t x = side % buffer_.columns;
        if (is_in_column && x > 0)
        {
          f(side - 1);
        }
        if (is_in_column && x + 1 < buffer_.columns)
        {
          f(side + 1);
        }
      });
}

bool Ridge::isBesideFree(size_t cell) const
{
  bool found = false;
  forEachNeighbour(
      cell, [&](size_t next)
      { found |= buffer_.zones[next] == kNone && buffer_.states[next] != kUnknown; });
  return found;
}

/** The way by which a search came becomes strip. */
void Ridge::cutBackFrom(size_t at)
{
  for (; buffer_.zones[cells_[at].cell] == kPerhaps; at = cells_[at].from)
  {
    buffer_.zones[cells_[at].cell] = kStrip;
  }
}

std::vector<size_t> Ridge::strips() const
{
  std::vector<size_t> found;
  for (size_t i = 0; i < cells_.size(); ++i)
  {
    if (buffer_.zones[cells_[i].cell] == kStrip)
    {
      found.push_back(i);
    }
  }
  return found;
}

/** All that hang together with one of a strip, by sides and corners. */
void Ridge::label(size_t seed, uint32_t label)
{
  std::vector<size_t> open = {seed};
  cells_[seed].label = label;
  const auto add = [&](size_t cell)
  {
    if (buffer_.zones[cell] == kStrip && cells_[at(cell)].label == 0)
    {
      open.push_back(at(cell));
      cells_[open.back()].label = label;
    }
  };
  while (!open.empty())
  {
    const size_t cell = cells_[open.back()].cell;
    open.pop_back();
    forEachNeighbour(cell, add);
    forEachCorner(cell, add);
  }
}

/** Returns the number of labels, with the 0 of all others. */
uint32_t Ridge::labelStrips()
{
  for (Cell& cell : cells_)
  {
    cell.label = 0;
  }
  uint32_t labels = 1;
  for (const size_t i : strips())
  {
    if (cells_[i].label == 0)
    {
      label(i, labels++);
    }
  }
  return labels;
}

/** Ragged walls have gaps in a strip: from all strips at once, over what may be ridge, as far as
 * the obstacles are away there; where two searches meet, they become one strip. */
void Ridge::joinStrips(uint32_t labels)
{
  Joined joined(labels);
  std::vector<size_t> open = strips();
  std::vector<float> steps(cells_.size());
  for (size_t next = 0; next < open.size(); ++next)
  {
    const size_t here = open[next];
    const auto meet = [&](size_t cell)
    {
      const size_t there = at(cell);
      const bool is_far = steps[here] + 1 > cells_[here].distance;
      if (cells_[there].label == 0 && !is_far)
      {
        cells_[there].label = cells_[here].label;
        cells_[there].from = here;
        steps[there] = steps[here] + 1;
        open.push_back(there);
      }
      else if (cells_[there].label != 0 && joined.join(cells_[here].label, cells_[there].label))
      {
        cutBackFrom(here);
        cutBackFrom(there);
      }
    };
    forEachNeighbour(
        cells_[here].cell,
        [&](size_t cell)
        {
          if (buffer_.zones[cell] == kPerhaps || buffer_.zones[cell] == kStrip)
          {
            meet(cell);
          }
        });
  }
}

/** From the strips over what may be ridge, as long as it recedes from obstacles; where that ends in
 * the open, the way is strip. */
void Ridge::leadOut()
{
  std::vector<size_t> open = strips();
  for (const size_t i : open)
  {
    cells_[i].farthest = cells_[i].distance;
  }
  for (size_t next = 0; next < open.size(); ++next)
  {
    const size_t here = open[next];
    if (isBesideFree(cells_[here].cell))
    {
      cutBackFrom(here);
      continue;
    }
    forEachNeighbour(
        cells_[here].cell,
        [&](size_t cell)
        {
          const size_t there = buffer_.zones[cell] == kPerhaps ? at(cell) : here;
          const float farthest = cells_[here].farthest;
          if (cells_[there].farthest == 0 && cells_[there].distance >= farthest - kSlack_cells)
          {
            cells_[there].farthest = std::max(farthest, cells_[there].distance);
            cells_[there].from = here;
            open.push_back(there);
          }
        });
  }
}

/** A strip is a way where it is longer than wide, or leads from the open to the open. Others are
 * dents of one obstacle. */
bool Ridge::isWay(std::span<const size_t> strip) const
{
  Extent seeds;
  Extent exits;
  float distance = 0;
  for (const size_t i : strip)
  {
    const auto x = static_cast<int32_t>(cells_[i].cell % buffer_.columns);
    const auto y = static_cast<int32_t>(cells_[i].cell / buffer_.columns);
    if (cells_[i].is_seed)
    {
      seeds.add(x, y);
      distance = std::max(distance, cells_[i].distance);
    }
    if (isBesideFree(cells_[i].cell))
    {
      exits.add(x, y);
    }
  }
  return static_cast<float>(seeds.longest()) >= 2 * distance ||
         exits.longest() >= kLeastPassage_cells;
}

void Ridge::dropDents(uint32_t labels)
{
  std::vector<std::vector<size_t>> by_label(labels);
  for (const size_t i : strips())
  {
    by_label[cells_[i].label].push_back(i);
  }
  for (const std::vector<size_t>& strip : by_label)
  {
    if (!isWay(strip))
    {
      for (const size_t i : strip)
      {
        buffer_.zones[cells_[i].cell] = kSoft;
      }
    }
  }
}

void Ridge::finish()
{
  sort();
  joinStrips(labelStrips());
  leadOut();
  for (const Cell& ridge : cells_)
  {
    uint8_t& zone = buffer_.zones[ridge.cell];
    zone = zone == kPerhaps ? kSoft : zone;
  }
  dropDents(labelStrips());
}
}  // namespace traverse::multi_lidar_grid
