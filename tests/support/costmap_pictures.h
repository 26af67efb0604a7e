// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/navigation/costmap.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

// Costmaps drawn as text, seen from above: the top row has the largest y, the lower left cell is
// (0, 0).
namespace traverse::testing
{
inline navigation::Passage drawnPassage(char c)
{
  using navigation::Passage;
  switch (c)
  {
    case ' ':
      return Passage::unknown;
    case 's':
      return Passage::soft;
    case 'H':
      return Passage::hard;
    case '#':
      return Passage::obstacle;
    default:
      return Passage::open;
  }
}

inline float drawnPrice(char c)
{
  if (c >= '1' && c <= '9')
  {
    return static_cast<float>(c - '0');
  }
  return c == ' ' ? 3.0F : c == 's' ? 5.0F : 1.0F;
}

/** '.' open, ' ' unknown at a price of 3, 's' soft at 5, 'H' hard, '#' obstacle; digits: open at
 * that price. */
inline navigation::Costmap drawnCostmap(const std::vector<std::string>& picture, int32_t cell_mm)
{
  navigation::Costmap map;
  map.lattice.cell_mm = cell_mm;
  map.extent = {
      {0, 0}, {static_cast<int32_t>(picture.front().size()), static_cast<int32_t>(picture.size())}};
  for (auto row = picture.rbegin(); row != picture.rend(); ++row)
  {
    for (const char c : *row)
    {
      map.passage.push_back(drawnPassage(c));
      map.price.push_back(drawnPrice(c));
    }
  }
  map.speed_mps.assign(map.size(), std::numeric_limits<float>::infinity());
  map.obstacle_m.assign(map.size(), std::numeric_limits<float>::quiet_NaN());
  return map;
}

/** An open square of `edge` cells, its lower left corner at map zero. */
inline navigation::Costmap openCostmap(int32_t edge, int32_t cell_mm)
{
  return drawnCostmap(
      std::vector<std::string>(
          static_cast<size_t>(edge), std::string(static_cast<size_t>(edge), '.')),
      cell_mm);
}

/** Sets the cells of a rectangle [min, max) that lie in the extent. */
inline void fill(
    navigation::Costmap& map, const geometry::CellRect& rect, navigation::Passage passage)
{
  for (int32_t y = rect.min.y; y < rect.max.y; ++y)
  {
    for (int32_t x = rect.min.x; x < rect.max.x; ++x)
    {
      if (map.extent.contains({x, y}))
      {
        map.passage[map.indexOf({x, y})] = passage;
      }
    }
  }
}

/** Hard cells within hard_m, soft ones within soft_m more of the obstacles' middles; slow and
 * plain. */
inline void growBuffers(navigation::Costmap& map, double hard_m, double soft_m)
{
  using navigation::Passage;
  const std::vector<Passage> drawn = map.passage;
  const double cell_m = map.lattice.cell_m();
  const auto reach = static_cast<int32_t>((hard_m + soft_m) / cell_m) + 1;
  for (int32_t k = 0; k < static_cast<int32_t>(drawn.size()); ++k)
  {
    if (drawn[static_cast<size_t>(k)] != Passage::obstacle)
    {
      continue;
    }
    const int32_t x = map.extent.min.x + k % map.extent.width();
    const int32_t y = map.extent.min.y + k / map.extent.width();
    for (int32_t j = 0; j < (2 * reach + 1) * (2 * reach + 1); ++j)
    {
      const int32_t dx = j % (2 * reach + 1) - reach;
      const int32_t dy = j / (2 * reach + 1) - reach;
      const double off_m = std::sqrt(double(dx * dx + dy * dy)) * cell_m;
      if (!map.extent.contains({x + dx, y + dy}) || off_m > hard_m + soft_m)
      {
        continue;
      }
      const size_t at = map.indexOf({x + dx, y + dy});
      const Passage grown = off_m <= hard_m ? Passage::hard : Passage::soft;
      if (grown > map.passage[at])
      {
        map.passage[at] = grown;
        map.price[at] = grown == Passage::soft ? 5.0F : map.price[at];
      }
    }
  }
}

/** An open square with `boxes` random rectangles of obstacle cells and random prices of 1 to 5. */
inline navigation::Costmap clutteredCostmap(int32_t edge, int32_t cell_mm, int boxes, uint32_t seed)
{
  std::mt19937 random(seed);
  const auto below = [&random](int32_t n)
  { return static_cast<int32_t>(random() % static_cast<uint32_t>(n)); };
  navigation::Costmap map = openCostmap(edge, cell_mm);
  for (int k = 0; k < boxes; ++k)
  {
    const int32_t x = below(edge);
    const int32_t y = below(edge);
    fill(
        map, {{x, y}, {x + 1 + below(edge / 12 + 1), y + 1 + below(edge / 12 + 1)}},
        navigation::Passage::obstacle);
  }
  for (float& price : map.price)
  {
    price = 1.0F + static_cast<float>(below(5)) * static_cast<float>(below(2));
  }
  return map;
}
}  // namespace traverse::testing
