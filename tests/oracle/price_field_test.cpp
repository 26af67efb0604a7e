// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// The field of prices against the plainest way to find it, and the walk over cells against small
// steps.
#include <traverse/navigation/price_field.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <support/costmap_pictures.h>

namespace
{
using namespace traverse;
using namespace traverse::navigation;
using namespace traverse::testing;

/** Bellman and Ford: every step between two cells until nothing gets cheaper. */
std::vector<double> slowField(const Costmap& map, geometry::CellIndex goal)
{
  std::vector<double> price(map.size(), PriceField::kNever);
  price[map.indexOf(goal)] = 0;
  const auto open = [&](int32_t x, int32_t y) { return map.passageAt({x, y}) == Passage::open; };
  for (bool changed = true; changed;)
  {
    changed = false;
    for (int32_t k = 0; k < static_cast<int32_t>(map.size()) * 9; ++k)
    {
      const int32_t x = map.extent.min.x + k / 9 % map.extent.width();
      const int32_t y = map.extent.min.y + k / 9 / map.extent.width();
      const int32_t dx = k % 3 - 1;
      const int32_t dy = k / 3 % 3 - 1;
      if (!open(x, y) || !open(x + dx, y) || !open(x, y + dy) || !open(x + dx, y + dy))
      {
        continue;
      }
      const size_t a = map.indexOf({x, y});
      const size_t b = map.indexOf({x + dx, y + dy});
      const double way = map.lattice.cell_m() * std::sqrt(double(dx * dx + dy * dy));
      const double through = price[b] + way * (map.price[a] + map.price[b]) / 2;
      if (through < price[a] - 1e-12)
      {
        price[a] = through;
        changed = true;
      }
    }
  }
  return price;
}

TEST(PriceField, IsThatOfTheSlowSearch)
{
  PriceField field;
  Terrain terrain;
  for (uint32_t seed = 0; seed < 60; ++seed)
  {
    Costmap map = clutteredCostmap(24, 200, 30, seed);
    map.extent = {{-7, 90}, {17, 114}};
    const geometry::CellIndex goal = {-7 + static_cast<int32_t>(seed % 24), 100};
    map.passage[map.indexOf(goal)] = Passage::open;
    terrain.set(map);
    const PriceField::Seed start = {terrain.indexOf(goal), 0};
    field.start(terrain, {&start, 1});
    const std::vector<double> expected = slowField(map, goal);
    for (size_t k = map.size(); k-- > 0;)
    {
      const geometry::CellIndex c = {
          -7 + static_cast<int32_t>(k % 24), 90 + static_cast<int32_t>(k / 24)};
      const double got = field.priceFrom(terrain.indexOf(c));
      if (std::isfinite(expected[k]))
      {
        ASSERT_NEAR(got, expected[k], 1e-9) << seed;  // another order of the same sums
      }
      else
      {
        ASSERT_EQ(got, expected[k]) << seed;
      }
    }
  }
}

TEST(PriceField, IsTheLeastOfSeveralSeedsAndWhatLiesBeyondThem)
{
  const Costmap map = clutteredCostmap(30, 200, 20, 3);
  Terrain terrain;
  terrain.set(map);
  std::vector<PriceField::Seed> seeds;
  for (const geometry::CellIndex c : {geometry::CellIndex{0, 0}, {29, 4}, {12, 29}, {28, 28}})
  {
    if (terrain.isOpen(terrain.indexOf(c)))
    {
      seeds.push_back({terrain.indexOf(c), 2.5 * static_cast<double>(seeds.size())});
    }
  }
  ASSERT_GE(seeds.size(), 3U);
  PriceField all;
  all.start(terrain, seeds);
  std::vector<PriceField> single(seeds.size());
  for (size_t k = 0; k < seeds.size(); ++k)
  {
    single[k].start(terrain, {&seeds[k], 1});
  }
  for (int32_t k = 0; k < 900; ++k)
  {
    const size_t index = terrain.indexOf({k % 30, k / 30});
    double least = PriceField::kNever;
    for (PriceField& field : single)
    {
      least = std::min(least, field.priceFrom(index));
    }
    ASSERT_EQ(all.priceFrom(index), least);
  }
}

TEST(PriceField, TakesPricesThatLieFarApart)
{
  Costmap map = clutteredCostmap(20, 20, 5, 1);
  for (size_t k = 0; k < map.size(); k += 3)
  {
    map.price[k] = 9e5F;
  }
  map.passage[map.indexOf({0, 0})] = Passage::open;
  Terrain terrain;
  terrain.set(map);
  const PriceField::Seed seed = {terrain.indexOf({0, 0}), 0};
  PriceField field;
  field.start(terrain, {&seed, 1});
  const std::vector<double> expected = slowField(map, {0, 0});
  for (int32_t k = 0; k < 400; ++k)
  {
    const double price = expected[static_cast<size_t>(k)];
    const double got = field.priceFrom(terrain.indexOf({k % 20, k / 20}));
    if (std::isfinite(price))
    {
      ASSERT_NEAR(got, price, 1e-9 * price);  // rounding of sums to 1e5
    }
  }
}

TEST(OverCells, MeetsTheCellsOfSmallStepsForTheirShareOfTheWay)
{
  std::mt19937 random(5);
  const geometry::Lattice lattice = {200};
  const auto coordinate = [&random]() { return static_cast<double>(random() % 8001) / 1000 - 4; };
  for (int k = 0; k < 500; ++k)
  {
    const Place a = {coordinate(), coordinate()};
    const Place b = {coordinate(), coordinate()};
    std::vector<std::pair<geometry::CellIndex, double>> walked;
    EXPECT_TRUE(overCells(
        a, b, lattice,
        [&](geometry::CellIndex c, double share)
        {
          walked.emplace_back(c, share);
          return true;
        }));
    constexpr int kSteps = 2000;
    for (const auto& [cell, share] : walked)
    {
      int inside = 0;
      for (int step = 0; step < kSteps; ++step)
      {
        const double t = (step + 0.5) / kSteps;
        const Place p = {a.x_m + t * (b.x_m - a.x_m), a.y_m + t * (b.y_m - a.y_m)};
        inside += cellOf(p, lattice) == cell ? 1 : 0;
      }
      ASSERT_NEAR(share, static_cast<double>(inside) / kSteps, 2.0 / kSteps);  // both ends
    }
    ASSERT_EQ(walked.back().first, cellOf(b, lattice));
  }
}

TEST(OverCells, TellsBothCellsBesideACornerThatItGoesThrough)
{
  std::vector<geometry::CellIndex> walked;
  overCells(
      {0.1, 0.1}, {0.5, 0.5}, {200},
      [&](geometry::CellIndex c, double)
      {
        walked.push_back(c);
        return true;
      });
  EXPECT_EQ(
      walked,
      (std::vector<geometry::CellIndex>{{0, 0}, {1, 0}, {0, 1}, {1, 1}, {2, 1}, {1, 2}, {2, 2}}));
}
}  // namespace
