// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plan_ends.h"

#include <cmath>

namespace traverse::navigation
{
namespace
{
double distance_m(Place a, Place b)
{
  const double dx = b.x_m - a.x_m;
  const double dy = b.y_m - a.y_m;
  return std::sqrt(dx * dx + dy * dy);
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
  const double mean = terrain.mean();
  std::vector<PriceField::Seed> ends;
  for (size_t index = 0; index < terrain.size(); ++index)
  {
    const auto [x, y] = terrain.cell(index);
    if (terrain.isOpen(index) &&
        (is_beyond(x - 1, y) || is_beyond(x + 1, y) || is_beyond(x, y - 1) || is_beyond(x, y + 1)))
    {
      ends.push_back({index, distance_m(terrain.centre(index), to) * mean});
    }
  }
  return ends;
}

std::vector<PriceField::Seed> placesNear(
    const Costmap& costmap, const Terrain& terrain, Place to, double nearness)
{
  const double of_metre = nearness * terrain.mean();
  std::vector<PriceField::Seed> places;
  for (size_t index = 0; index < terrain.size(); ++index)
  {
    if (terrain.isOpen(index) && costmap.passageAt(terrain.cell(index)) == Passage::open)
    {
      places.push_back({index, distance_m(terrain.centre(index), to) * of_metre});
    }
  }
  return places;
}
}  // namespace traverse::navigation
