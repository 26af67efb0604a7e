// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/traversability_grid/scan_cells.h>

namespace traverse::traversability_grid
{
namespace
{
uint32_t addSlab(
    std::vector<ScanSlab>& slabs, geometry::CellIndex cell, int32_t level, uint32_t next)
{
  ScanSlab& slab = slabs.emplace_back();
  slab.cell = cell;
  slab.level = level;
  slab.next = next;
  return static_cast<uint32_t>(slabs.size() - 1);
}
}  // namespace

void ScanCells::begin(const geometry::CellRect& window, const Limits& most, size_t points)
{
  numbers_.resize(std::max<size_t>(numbers_.size(), kBlock), kNone);
  for (const ScanSlab& slab : cells_)
  {
    numbers_[entryOf(slab.cell)] = kNone;
  }
  for (const size_t tile : tiles_)
  {
    directory_[tile] = 0;
  }
  tiles_.clear();
  cells_.clear();
  more_.clear();
  of_points_.clear();
  of_points_.reserve(points);
  refused_ = 0;
  most_ = most;
  const auto down = [](int32_t cell) { return cell & ~(kSide - 1); };
  origin_ = {down(window.min.x), down(window.min.y)};
  shift_ = {window.min.x - origin_.x, window.min.y - origin_.y};
  columns_ = window.empty() ? 0 : down(shift_.x + window.width() + kSide - 1);
  rows_ = window.empty() ? 0 : down(shift_.y + window.height() + kSide - 1);
  directory_.resize(static_cast<size_t>(columns_ >> kShift) * static_cast<size_t>(rows_ >> kShift));
}

void ScanCells::add(const LatticePoints& points)
{
  const size_t before = of_points_.size();
  number(points);
  for (size_t i = 0; i < points.size; ++i)
  {
    const uint32_t number = of_points_[before + i];
    if (number == kNone)
    {
      continue;
    }
    ScanSlab& first = cells_[number];
    const bool is_first = first.level == points.level[i] && first.n() < most_.slab_points;
    ScanSlab& slab = is_first ? first : otherSlab(number, points.level[i]);
    slab.add(
        static_cast<uint64_t>(points.x_mm[i]), static_cast<uint64_t>(points.y_mm[i]),
        static_cast<uint64_t>(points.z_mm[i]));
  }
}

/** Where the cell has its number, counted from the window's corner; 0 where a point is left out, as
 * those that would need a tile too many. */
inline uint32_t ScanCells::findEntry(int32_t column, int32_t row)
{
  if (column < 0)
  {
    return 0;
  }
  const size_t tile = tileOf(column + shift_.x, row + shift_.y);
  if (directory_[tile] == 0 && !makeBlock(tile))
  {
    ++refused_;
    return 0;
  }
  return entryOf(directory_[tile], column + shift_.x, row + shift_.y);
}

/** In steps of their own, so that each finds what it needs on its way from memory: where the
 * points' cells have their numbers, the numbers, then (add()) the sums. */
void ScanCells::number(const LatticePoints& points)
{
  std::array<uint32_t, LatticePoints::kMost> entries{};
  for (size_t i = 0; i < points.size; ++i)
  {
    entries[i] = findEntry(points.column[i], points.row[i]);
    __builtin_prefetch(numbers_.data() + entries[i], 1);
  }
  const size_t before = of_points_.size();
  of_points_.resize(before + points.size, kNone);
  for (size_t i = 0; i < points.size; ++i)
  {
    if (entries[i] == 0)
    {
      continue;
    }
    uint32_t& number = numbers_[entries[i]];
    if (number == kNone)
    {
      const geometry::CellIndex corner{origin_.x + shift_.x, origin_.y + shift_.y};
      number = addSlab(
          cells_, {corner.x + points.column[i], corner.y + points.row[i]}, points.level[i], kNone);
    }
    of_points_[before + i] = number;
    __builtin_prefetch(&cells_[number], 1);
  }
}

bool ScanCells::makeBlock(size_t tile)
{
  if (tiles_.size() == most_.tiles)
  {
    return false;
  }
  tiles_.push_back(tile);
  directory_[tile] = static_cast<uint32_t>(tiles_.size());
  numbers_.resize(std::max(numbers_.size(), (tiles_.size() + 1) * kBlock), kNone);
  return true;
}

uint32_t ScanCells::entryOf(geometry::CellIndex cell) const
{
  const int32_t column = cell.x - origin_.x;
  const int32_t row = cell.y - origin_.y;
  return entryOf(directory_[tileOf(column, row)], column, row);
}

/** A slab of that level with room, beyond the cell's first. */
ScanSlab& ScanCells::otherSlab(uint32_t number, int32_t level)
{
  ScanSlab& first = cells_[number];
  for (uint32_t i = first.next; i != kNone; i = more_[i].next)
  {
    if (more_[i].level == level && more_[i].n() < most_.slab_points)
    {
      return more_[i];
    }
  }
  first.next = addSlab(more_, first.cell, level, first.next);
  return more_.back();
}

void ScanCells::remove(const std::vector<bool>& is_gone)
{
  std::vector<uint32_t> now(cells_.size(), kNone);
  uint32_t kept = 0;
  for (size_t i = 0; i < cells_.size(); ++i)
  {
    now[i] = is_gone[i] ? kNone : kept;
    numbers_[entryOf(cells_[i].cell)] = now[i];
    cells_[kept] = cells_[i];
    kept += is_gone[i] ? 0 : 1;
  }
  cells_.resize(kept);
  for (uint32_t& number : of_points_)
  {
    number = number == kNone ? kNone : now[number];
  }
}
}  // namespace traverse::traversability_grid
