// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "paper_lidar.h"

#include "azimuth.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace traverse::multi_lidar_grid
{
namespace
{
using geometry::CellIndex;
using geometry::CellRect;
using layers::OccupancyState;

/** Directions in a turn: three to a cell at 100 m of 0.2 m. */
constexpr int32_t kDirections = 8192;
constexpr int32_t kHalf = kDirections / 2;

int32_t directionOf(float turn)
{
  return static_cast<int32_t>(std::floor(turn * static_cast<float>(kDirections)));
}

/** The square around a circle of so many cells, within the region. */
CellRect around(CellIndex middle, double reach_cells, const CellRect& region)
{
  const auto reach = static_cast<int32_t>(std::min(reach_cells, 1e6)) + 1;
  return geometry::intersection(
      {{middle.x - reach, middle.y - reach}, {middle.x + reach + 1, middle.y + reach + 1}}, region);
}

/** Whether the field of view has a direction in the plane. */
bool inView(const BeamFrame& frame, int32_t dx, int32_t dy)
{
  const auto x = static_cast<float>(dx);
  const auto y = static_cast<float>(dy);
  const bool after_first = x * frame.first_normal[0] + y * frame.first_normal[1] >= 0;
  const bool before_last = x * frame.last_normal[0] + y * frame.last_normal[1] >= 0;
  return frame.is_wide ? (after_first || before_last) : (after_first && before_last);
}
}  // namespace

void PaperLidar::layOut(int32_t edge)
{
  depth2_.assign(kDirections, std::numeric_limits<int32_t>::max());
  if (edge == edge_)
  {
    return;
  }
  edge_ = edge;
  quarter_.resize(static_cast<size_t>(edge) * static_cast<size_t>(edge));
  size_t i = 0;
  for (int32_t y = 0; y < edge; ++y)
  {
    for (int32_t x = 0; x < edge; ++x)
    {
      const float turn =
          x == 0 && y == 0 ? 0.0F : turnOf(static_cast<float>(x), static_cast<float>(y));
      quarter_[i++] = static_cast<uint16_t>(std::min(directionOf(turn), kDirections / 4 - 1));
    }
  }
}

/** No ray goes further in the directions that touch this cell, one more to each side. */
void PaperLidar::block(int32_t dx, int32_t dy)
{
  if (dx == 0 && dy == 0)
  {
    return;
  }
  const auto x = static_cast<float>(dx);
  const auto y = static_cast<float>(dy);
  const float middle = turnOf(x, y);
  float low = 0;
  float high = 0;
  for (const float side_x : {-0.5F, 0.5F})
  {
    for (const float side_y : {-0.5F, 0.5F})
    {
      float off = turnOf(x + side_x, y + side_y) - middle;
      off = off > 0.5F ? off - 1 : off < -0.5F ? off + 1 : off;
      low = std::min(low, off);
      high = std::max(high, off);
    }
  }
  const int32_t square = dx * dx + dy * dy;
  const int32_t last = directionOf(middle + high) + 1;
  for (int32_t d = directionOf(middle + low) - 1; d <= last; ++d)
  {
    int32_t& depth2 = depth2_[static_cast<size_t>(d & (kDirections - 1))];
    depth2 = std::min(depth2, square);
  }
}

CellRect PaperLidar::trace(const BeamFrame& frame, CellIndex stand, uint8_t up_to, UnitMap& map)
{
  const CellRect& region = map.cells.region();
  layOut(region.width());
  if (!region.contains(stand))
  {
    return {};
  }
  const double reach_cells = std::sqrt(frame.range2_m2) / frame.cell_mm * 1000;
  const CellRect part = around(stand, reach_cells, region);
  map.cells.forEachRunIn(
      geometry::intersection(part, map.touched),
      [&](CellIndex first, std::span<UnitCell> run)
      {
        for (size_t i = 0; i < run.size(); ++i)
        {
          if (run[i].state == OccupancyState::obstacle)
          {
            block(first.x + static_cast<int32_t>(i) - stand.x, first.y - stand.y);
          }
        }
      });
  const auto most2 = static_cast<int32_t>(std::min(reach_cells * reach_cells, 2e9));
  map.cells.forEachRunIn(
      part,
      [&](CellIndex first, std::span<UnitCell> run)
      {
        const int32_t dy = first.y - stand.y;
        const uint16_t* const row =
            quarter_.data() + static_cast<size_t>(std::abs(dy)) * static_cast<size_t>(edge_);
        for (size_t i = 0; i < run.size(); ++i)
        {
          const int32_t dx = first.x + static_cast<int32_t>(i) - stand.x;
          const int32_t quarter = row[std::abs(dx)];
          const int32_t upper = dx < 0 ? kHalf - 1 - quarter : quarter;
          const int32_t direction = dy < 0 ? kDirections - 1 - upper : upper;
          const int32_t square = dx * dx + dy * dy;
          const bool is_seen = square < depth2_[static_cast<size_t>(direction)] && square <= most2;
          UnitCell& cell = run[i];
          if (is_seen && cell.state == OccupancyState::unknown &&
              (!frame.has_view || inView(frame, dx, dy)))
          {
            cell.state = OccupancyState::free;
            cell.up_to = up_to;
          }
        }
      });
  return part;
}
}  // namespace traverse::multi_lidar_grid
