// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells that are opened for one plan because the vehicle stands, or the goal lies, where nothing is
// planned.
#include "way_out.h"

#include "room.h"

#include <traverse/layers/distance_transform.h>
#include <traverse/navigation/cell_walk.h>
#include <traverse/navigation/terrain.h>

namespace traverse::navigation
{
namespace
{
using geometry::CellIndex;

/** Squared distance of each cell to the nearest obstacle, in cells. */
std::vector<int32_t> distances(const Costmap& costmap)
{
  std::vector<uint8_t> obstacles(costmap.size());
  for (size_t k = 0; k < obstacles.size(); ++k)
  {
    obstacles[k] = costmap.passage[k] == Passage::obstacle ? 1 : 0;
  }
  constexpr int32_t kReach_cells = 400;
  layers::DistanceTransform transform(
      obstacles, costmap.extent.width(), kReach_cells * kReach_cells);
  std::vector<int32_t> all;
  all.reserve(obstacles.size());
  layers::NearestRow row;
  for (int32_t y = 0; y < transform.rows(); ++y)
  {
    transform.row(y, row);
    all.insert(all.end(), row.squared.begin(), row.squared.end());
  }
  return all;
}

/** f(neighbour) for the eight around a cell. */
template <class F>
void forNeighbours(CellIndex c, F&& f)
{
  for (int32_t dy = -1; dy <= 1; ++dy)
  {
    for (int32_t dx = -1; dx <= 1; ++dx)
    {
      if (dx != 0 || dy != 0)
      {
        f(CellIndex{c.x + dx, c.y + dy});
      }
    }
  }
}
}  // namespace

void Terrain::openSoftAround(const Costmap& costmap, std::vector<CellIndex>& front)
{
  const auto offer = [&](CellIndex c)
  {
    if (costmap.passageAt(c) != Passage::soft || isOpen(indexOf(c)))
    {
      return;
    }
    open(indexOf(c), costmap.price[costmap.indexOf(c)]);
    if (isOpen(indexOf(c)))
    {
      front.push_back(c);
    }
  };
  while (!front.empty())
  {
    const CellIndex c = front.back();
    front.pop_back();
    forNeighbours(c, offer);
  }
}

void Terrain::openSoft(const Costmap& costmap, CellIndex from)
{
  if (costmap.passageAt(from) != Passage::soft)
  {
    return;
  }
  open(indexOf(from), costmap.price[costmap.indexOf(from)]);
  std::vector<CellIndex> front = {from};
  openSoftAround(costmap, front);
}

void Terrain::openBesideStrips(const Costmap& costmap, int32_t reach, int32_t room)
{
  const int32_t edge = 2 * reach + 1;
  const double room_m = room * lattice_.cell_m();
  for (const CellIndex& c : costmap.strip)
  {
    if (room > 0 && roomAt(costmap, c, room) <= room_m)
    {
      price_[indexOf(c)] = kClosed;
      continue;
    }
    for (int32_t i = 0; i < edge * edge; ++i)
    {
      const CellIndex beside = {c.x - reach + i % edge, c.y - reach + i / edge};
      if (costmap.passageAt(beside) == Passage::soft && !isOpen(indexOf(beside)))
      {
        open(indexOf(beside), costmap.price[costmap.indexOf(beside)]);
      }
    }
  }
}

void Terrain::openWayOut(const Costmap& costmap, CellIndex from, double radius_m)
{
  if (costmap.passageAt(from) < Passage::hard)
  {
    openSoft(costmap, from);
    return;
  }
  const std::vector<int32_t> squared = distances(costmap);
  const double radius_cells = radius_m / lattice_.cell_m();
  const auto may_pass = [&](CellIndex n, CellIndex before)
  {
    const Passage passage = costmap.passageAt(n);
    const double dx = n.x - from.x;
    const double dy = n.y - from.y;
    return !isOpen(indexOf(n)) &&
           (passage == Passage::hard ||
            (passage == Passage::obstacle && dx * dx + dy * dy <= radius_cells * radius_cells)) &&
           squared[costmap.indexOf(n)] >= squared[costmap.indexOf(before)];
  };
  const auto open_cell = [&](CellIndex c)
  { open(indexOf(c), costmap.price[costmap.indexOf(c)] + kWayOutPrice); };
  std::vector<CellIndex> front = {from};
  std::vector<CellIndex> passed;
  open_cell(from);
  while (!front.empty())
  {
    const CellIndex c = front.back();
    front.pop_back();
    passed.push_back(c);
    forNeighbours(
        c,
        [&](CellIndex n)
        {
          if (extent_.contains(n) && may_pass(n, c))
          {
            open_cell(n);
            front.push_back(n);
          }
        });
  }
  openSoftAround(costmap, passed);
}

double wayOut_m(const Costmap& costmap, const Path& path)
{
  const auto is_passed = [&](geometry::CellIndex c, double)
  { return costmap.passageAt(c) < Passage::hard; };
  for (size_t k = path.size(); k-- > 1;)
  {
    const geometry::Pose2& a = path[k - 1].pose;
    const geometry::Pose2& b = path[k].pose;
    if (!overCells({a.x_m, a.y_m}, {b.x_m, b.y_m}, costmap.lattice, is_passed))
    {
      return path[k].along_m;
    }
  }
  return 0;
}
}  // namespace traverse::navigation
