// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plan_ends.h"

#include <traverse/navigation/cell_walk.h>

namespace traverse::navigation
{
namespace
{
/** A place that is wanted; a metre further from `to` costs so much. */
template <class Wanted>
std::vector<PriceField::Seed> seedsAt(
    const Terrain& terrain, Place to, double price_of_metre, const Wanted& is_wanted)
{
  std::vector<PriceField::Seed> seeds;
  for (size_t index = 0; index < terrain.size(); ++index)
  {
    if (terrain.isOpen(index) && is_wanted(terrain.cell(index)))
    {
      seeds.push_back({index, distance_m(terrain.centre(index), to) * price_of_metre});
    }
  }
  return seeds;
}
}  // namespace

std::vector<PriceField::Seed> endsOfTheKnown(
    const Costmap& costmap, const Terrain& terrain, Place to)
{
  const auto is_beyond = [&](int32_t x, int32_t y)
  {
    return !costmap.extent.contains({x, y}) ||
           (!costmap.is_unknown_planned && costmap.passageAt({x, y}) == Passage::unknown);
  };
  const auto is_end = [&](geometry::CellIndex c)
  {
    return is_beyond(c.x - 1, c.y) || is_beyond(c.x + 1, c.y) || is_beyond(c.x, c.y - 1) ||
           is_beyond(c.x, c.y + 1);
  };
  return seedsAt(terrain, to, terrain.mean(), is_end);
}

std::vector<PriceField::Seed> placesNear(
    const Costmap& costmap, const Terrain& terrain, Place to, double nearness)
{
  const auto is_open = [&](geometry::CellIndex c) { return costmap.passageAt(c) == Passage::open; };
  return seedsAt(terrain, to, nearness * terrain.mean(), is_open);
}
}  // namespace traverse::navigation
