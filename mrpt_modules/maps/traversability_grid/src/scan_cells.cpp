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
  slab.min_z_mm = std::numeric_limits<uint16_t>::max();
  return static_cast<uint32_t>(slabs.size() - 1);
}
}  // namespace

layers::HeightSlab ScanSlab::sums(poses::TimeNs stamp) const
{
  layers::HeightSlab slab;
  slab.level = level;
  slab.n = n;
  slab.min_z_mm = min_z_mm;
  slab.max_z_mm = max_z_mm;
  slab.last_seen = stamp;
  slab.x = x;
  slab.y = y;
  slab.z = z;
  slab.xx = xx;
  slab.xy = xy;
  slab.yy = yy;
  slab.xz = xz;
  slab.yz = yz;
  slab.zz = zz;
  return slab;
}

void ScanCells::begin(const geometry::CellRect& window, const Limits& most, size_t points)
{
  if (blocks_.empty())
  {
    blocks_.emplace_back().fill(kNone);
  }
  for (const ScanSlab& slab : cells_)
  {
    entryOf(slab.cell) = kNone;
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
    const bool is_first = first.level == points.level[i] && first.n < most_.slab_points;
    ScanSlab& slab = is_first ? first : otherSlab(number, points.level[i]);
    slab.add(
        static_cast<uint32_t>(points.x_mm[i]), static_cast<uint32_t>(points.y_mm[i]),
        static_cast<uint32_t>(points.z_mm[i]));
  }
}

/** Makes the cell where the scan meets it for the first time; kNone where it would need a tile too
 * many. */
inline uint32_t ScanCells::numberAt(int32_t column, int32_t row, int32_t level)
{
  const Position p = positionOf(column, row);
  if (directory_[p.tile] == 0 && !makeBlock(p.tile))
  {
    return kNone;
  }
  uint32_t& entry = blocks_[directory_[p.tile]][p.offset];
  if (entry == kNone)
  {
    entry = addSlab(cells_, {origin_.x + column, origin_.y + row}, level, kNone);
  }
  return entry;
}

/** Ahead of the sums, so that their cache lines are on the way when they are needed. */
void ScanCells::number(const LatticePoints& points)
{
  const size_t before = of_points_.size();
  of_points_.resize(before + points.size);
  for (size_t i = 0; i < points.size; ++i)
  {
    uint32_t number = kNone;
    if (points.column[i] >= 0)
    {
      number = numberAt(points.column[i] + shift_.x, points.row[i] + shift_.y, points.level[i]);
      refused_ += static_cast<uint64_t>(number == kNone);
    }
    of_points_[before + i] = number;
    __builtin_prefetch(cells_.data() + number, 1);
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
  if (blocks_.size() == tiles_.size())
  {
    blocks_.emplace_back().fill(kNone);
  }
  return true;
}

uint32_t& ScanCells::entryOf(geometry::CellIndex cell)
{
  const Position p = positionOf(cell.x - origin_.x, cell.y - origin_.y);
  return blocks_[directory_[p.tile]][p.offset];
}

/** A slab of that level with room, beyond the cell's first. */
ScanSlab& ScanCells::otherSlab(uint32_t number, int32_t level)
{
  ScanSlab& first = cells_[number];
  for (uint32_t i = first.next; i != kNone; i = more_[i].next)
  {
    if (more_[i].level == level && more_[i].n < most_.slab_points)
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
    entryOf(cells_[i].cell) = now[i];
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
