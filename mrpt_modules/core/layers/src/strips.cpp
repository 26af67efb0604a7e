// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ridge.h"

#include <algorithm>
#include <limits>

namespace traverse::layers
{
namespace
{
constexpr auto kSoft = static_cast<uint8_t>(BufferZone::soft);
constexpr auto kStrip = static_cast<uint8_t>(BufferZone::strip);

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

}  // namespace

/** All that hang together with one of a strip, by sides and corners. */
void Ridge::label(size_t seed, uint32_t label)
{
  std::vector<size_t> open = {seed};
  cells_[seed].label = label;
  const auto add = [&](size_t cell)
  {
    if (buffer_.zones[cell] == kStrip && cells_[index_[cell]].label == 0)
    {
      open.push_back(index_[cell]);
      cells_[open.back()].label = label;
    }
  };
  while (!open.empty())
  {
    const size_t cell = cells_[open.back()].cell;
    open.pop_back();
    buffer_.forEachNeighbour(cell, add);
    buffer_.forEachCorner(cell, add);
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
    if (buffer_.isBesideFree(cells_[i].cell))
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

}  // namespace traverse::layers
