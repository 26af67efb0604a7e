// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cell_columns.h"

#include <algorithm>

namespace traverse::multi_lidar_grid
{
namespace
{
constexpr int32_t kLowest = std::numeric_limits<int32_t>::min();
constexpr int32_t kHighest = std::numeric_limits<int32_t>::max();

bool byGround(const Rules& rules, const Column& column)
{
  return rules.cells == CellRule::standard && column.ground != Column::kNoGround;
}
}  // namespace

void CellColumns::collect(const BeamPoints& points, size_t cells)
{
  if (slots_.size() != cells)
  {
    slots_.assign(cells, -1);
  }
  else
  {
    for (const Column& column : columns_)
    {
      slots_[static_cast<size_t>(column.cell)] = -1;
    }
  }
  columns_.clear();
  for (size_t i = 0; i < points.size; ++i)
  {
    if (points.cell[i] < 0)
    {
      continue;
    }
    const int32_t z = points.z_mm[i];
    int32_t& slot = slots_[static_cast<size_t>(points.cell[i])];
    if (slot < 0)
    {
      slot = static_cast<int32_t>(columns_.size());
      Column column;
      column.cell = points.cell[i];
      column.low = column.high = z;
      column.below = column.hits_to = kLowest;
      column.above = kHighest;
      columns_.push_back(column);
    }
    Column& column = columns_[static_cast<size_t>(slot)];
    column.low = std::min(column.low, z);
    column.high = std::max(column.high, z);
    ++column.count;
  }
}

void CellColumns::compare(const BeamPoints& points)
{
  for (size_t i = 0; i < points.size; ++i)
  {
    if (points.cell[i] < 0)
    {
      continue;
    }
    Column& c = columns_[static_cast<size_t>(slots_[static_cast<size_t>(points.cell[i])])];
    const int32_t z = points.z_mm[i];
    const bool is_above = z > c.limit;
    const bool is_high = z > c.top;
    c.below = std::max(c.below, is_above ? kLowest : z);
    c.above = std::min(c.above, is_above ? z : kHighest);
    c.hits_to = std::max(c.hits_to, is_above && !is_high ? z : kLowest);
    c.count_high += is_high ? 1U : 0U;
  }
}

void setLimits(const Rules& rules, int32_t obstacle_mm, Column& column)
{
  if (byGround(rules, column))
  {
    column.limit = column.ground + obstacle_mm;
    column.top = column.ground + rules.robot_mm;
  }
  else
  {
    column.limit = column.low + rules.obstacle_mm - 1;
    column.top = column.low + rules.robot_mm;
  }
}

Returns judge(const Rules& rules, const Column& column)
{
  if (!byGround(rules, column))
  {
    // below is the last return less than T_p over the lowest, above the next one: the only gap that
    // can be an overhang's.
    if (column.high - column.low <= rules.obstacle_mm)
    {
      return Returns::nothing;
    }
    return column.above - column.below > rules.robot_mm ? Returns::overhang : Returns::obstacle;
  }
  if (column.hits_to != kLowest)
  {
    return Returns::obstacle;
  }
  const bool hangs = column.count_high > 0;
  if (column.below == kLowest)
  {
    return hangs ? Returns::hanging : Returns::nothing;
  }
  if (column.below < column.ground - rules.obstacle_mm)
  {
    return hangs ? Returns::hanging : Returns::below;
  }
  return hangs ? Returns::overhang : Returns::ground;
}
}  // namespace traverse::multi_lidar_grid
