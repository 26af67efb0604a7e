// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/geometry/floor_divider.h>
#include <traverse/layers/tile_grid.h>

#include <gtest/gtest.h>

#include <random>

namespace
{
using traverse::geometry::CellIndex;
using traverse::geometry::CellRect;
using Grid = traverse::layers::TileGrid<int>;

constexpr size_t kMany = 1000;

void put(Grid& grid, CellIndex cell, int value)
{
  grid.at(*grid.obtain(cell, kMany)) = value;
}

std::vector<CellIndex> filled(const Grid& grid, const CellRect& window)
{
  std::vector<CellIndex> cells;
  grid.forEachIn(
      window,
      [&](Grid::Place place)
      {
        if (grid.at(place) != 0)
        {
          cells.push_back(grid.indexOf(place));
        }
      });
  return cells;
}

constexpr CellRect kAll{{-1000, -1000}, {1000, 1000}};

TEST(TileGrid, FindsCellsOnBothSidesOfZeroAndFarOut)
{
  Grid grid;
  const std::vector<CellIndex> cells = {
      {0, 0}, {-1, 0}, {0, -1}, {-33, 31}, {1'000'000'000, -1'000'000'000}};
  for (size_t i = 0; i < cells.size(); ++i)
  {
    put(grid, cells[i], static_cast<int>(i) + 1);
  }
  for (size_t i = 0; i < cells.size(); ++i)
  {
    ASSERT_NE(grid.get(cells[i]), nullptr);
    EXPECT_EQ(*grid.get(cells[i]), static_cast<int>(i) + 1);
    EXPECT_EQ(grid.indexOf(*grid.find(cells[i])), cells[i]);
  }
  EXPECT_EQ(grid.get({5000, 0}), nullptr);
  EXPECT_EQ(grid.find({5000, 0}), std::nullopt);
}

TEST(TileGrid, TilesThatShareALowPositionAreToldApart)
{
  Grid grid;
  const int32_t period = 32 * Grid::kSide;  // the recent-tiles table repeats after so many cells
  for (int round = 0; round < 2; ++round)
  {
    for (int i = -2; i <= 2; ++i)
    {
      put(grid, {i * period, 0}, i + 10);
    }
  }
  EXPECT_EQ(grid.tiles(), 5U);
  for (int i = -2; i <= 2; ++i)
  {
    EXPECT_EQ(*grid.get({i * period, 0}), i + 10);
  }
}

TEST(TileGrid, ReadsInTheSameOrderHoweverItWasFilled)
{
  std::vector<CellIndex> cells;
  for (int i = -50; i < 50; ++i)
  {
    cells.push_back({i * 7, i * i % 91 - 40});
  }
  Grid forward;
  Grid shuffled;
  for (const CellIndex c : cells)
  {
    put(forward, c, 1);
  }
  std::shuffle(cells.begin(), cells.end(), std::mt19937(5));
  for (const CellIndex c : cells)
  {
    put(shuffled, c, 1);
  }
  EXPECT_EQ(filled(forward, kAll), filled(shuffled, kAll));
  EXPECT_EQ(filled(forward, kAll).size(), 100U);
}

TEST(TileGrid, AWindowShowsItsCellsOnly)
{
  Grid grid;
  put(grid, {-1, -1}, 1);
  put(grid, {0, 0}, 1);
  put(grid, {9, 4}, 1);
  put(grid, {10, 4}, 1);
  EXPECT_EQ(filled(grid, {{0, 0}, {10, 5}}), (std::vector<CellIndex>{{0, 0}, {9, 4}}));
  EXPECT_TRUE(filled(grid, {{3, 3}, {3, 9}}).empty());
}

TEST(TileGrid, MakesNoMoreTilesThanAllowed)
{
  Grid grid;
  EXPECT_TRUE(grid.obtain({0, 0}, 1));
  EXPECT_FALSE(grid.obtain({100, 0}, 1));
  EXPECT_TRUE(grid.obtain({1, 1}, 1)) << "the same tile";
}

TEST(TileGrid, ReleasedTilesAreEmptyAndUsedAgain)
{
  Grid grid;
  put(grid, {0, 0}, 1);
  put(grid, {100, 0}, 2);
  grid.releaseTiles({{0, 0}, {32, 32}}, {{50, 0}, {200, 32}});
  EXPECT_EQ(grid.tiles(), 1U);
  EXPECT_EQ(grid.get({0, 0}), nullptr);
  EXPECT_EQ(*grid.get({100, 0}), 2);
  EXPECT_EQ(grid.at(*grid.obtain({0, 0}, kMany)), 0);
}

TEST(TileGrid, ACopyIsIndependent)
{
  Grid grid;
  put(grid, {1, 2}, 1);
  Grid copy = grid;
  put(copy, {1, 2}, 9);
  EXPECT_EQ(*grid.get({1, 2}), 1);
}

TEST(FloorDivider, AgreesWithTheSlowDivision)
{
  std::mt19937_64 random(3);
  for (const int64_t divisor : {1, 7, 10, 200, 333, 500, 10000, 2147483647})
  {
    const traverse::geometry::FloorDivider divide(divisor);
    for (int i = 0; i < 20000; ++i)
    {
      const int64_t near = static_cast<int64_t>(random() % 2001) - 1000;
      const int64_t multiple = static_cast<int64_t>(random() % 1'000'000) - 500'000;
      const int64_t any = static_cast<int64_t>(random() >> 14U) - (int64_t{1} << 49U);
      for (const int64_t dividend : {near, multiple * (divisor % 100'000) + near % 3, any})
      {
        const auto [quotient, remainder] = divide(dividend);
        ASSERT_EQ(quotient, traverse::geometry::floorDiv(dividend, divisor)) << dividend;
        ASSERT_EQ(remainder, traverse::geometry::floorMod(dividend, divisor)) << dividend;
      }
    }
  }
}
}  // namespace
