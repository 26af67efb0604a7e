// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "known_ends.h"

#include <cmath>

namespace traverse::navigation
{
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
      const Place place = terrain.centre(index);
      const double dx = to.x_m - place.x_m;
      const double dy = to.y_m - place.y_m;
      ends.push_back({index, std::sqrt(dx * dx + dy * dy) * mean});
    }
  }
  return ends;
}
}  // namespace traverse::navigation
