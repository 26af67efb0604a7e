// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// The distance transform against the obvious way: all obstacles for every cell.
#include <traverse/layers/distance_transform.h>

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <stdexcept>
#include <tuple>
#include <vector>

namespace
{
using traverse::layers::DistanceTransform;
using traverse::layers::NearestRow;

struct Grid
{
  int32_t columns = 0;
  int32_t rows = 0;
  std::vector<uint8_t> cells;
};

Grid randomGrid(int32_t columns, int32_t rows, double share, uint32_t seed)
{
  Grid grid{columns, rows, {}};
  std::mt19937 random(seed);
  std::bernoulli_distribution is_obstacle(share);
  for (int32_t i = 0; i < columns * rows; ++i)
  {
    grid.cells.push_back(is_obstacle(random) ? 7 : 0);
  }
  return grid;
}

using Nearest = std::tuple<int32_t, int32_t, int32_t>;  // squared, dx, dy; the least is the nearest

Nearest slowAt(const Grid& grid, int32_t x, int32_t y)
{
  Nearest best = {NearestRow::kNone, 0, 0};
  for (int32_t at = 0; at < grid.columns * grid.rows; ++at)
  {
    const int32_t dx = at % grid.columns - x;
    const int32_t dy = at / grid.columns - y;
    if (grid.cells[static_cast<size_t>(at)] != 0)
    {
      best = std::min(best, Nearest{dx * dx + dy * dy, dx, dy});
    }
  }
  return best;
}

std::vector<Nearest> slow(const Grid& grid)
{
  std::vector<Nearest> all;
  for (int32_t y = 0; y < grid.rows; ++y)
  {
    for (int32_t x = 0; x < grid.columns; ++x)
    {
      all.push_back(slowAt(grid, x, y));
    }
  }
  return all;
}

/** Without those that are out of reach. */
std::vector<Nearest> within(std::vector<Nearest> all, int32_t most_squared)
{
  for (Nearest& nearest : all)
  {
    nearest = std::get<0>(nearest) <= most_squared ? nearest : Nearest{NearestRow::kNone, 0, 0};
  }
  return all;
}

std::vector<Nearest> fast(const Grid& grid, int32_t most_squared)
{
  DistanceTransform transform(grid.cells, grid.columns, most_squared);
  EXPECT_EQ(transform.rows(), grid.rows);
  std::vector<Nearest> all;
  NearestRow row;
  for (int32_t y = 0; y < grid.rows; ++y)
  {
    transform.row(y, row);
    for (size_t x = 0; x < row.squared.size(); ++x)
    {
      all.emplace_back(row.squared[x], row.dx[x], row.dy[x]);
    }
  }
  return all;
}

TEST(DistanceTransform, FindsTheNearestObstacleOfEveryCell)
{
  constexpr std::array kReaches = {0, 1, 2, 5, 24, 224, 225, 255, 256, 300, 5000, 268402689};
  uint32_t seed = 0;
  for (const auto& [columns, rows] :
       {std::pair<int32_t, int32_t>{1, 1},
        {1, 40},
        {40, 1},
        {31, 33},
        {32, 20},
        {70, 45},
        {97, 12}})
  {
    for (const double share : {0.0, 0.001, 0.01, 0.1, 0.6, 1.0})
    {
      const Grid grid = randomGrid(columns, rows, share, ++seed);
      const std::vector<Nearest> all = slow(grid);
      for (const int32_t most_squared : kReaches)
      {
        ASSERT_EQ(fast(grid, most_squared), within(all, most_squared))
            << columns << " x " << rows << ", " << share << ", " << most_squared;
      }
    }
  }
}

TEST(DistanceTransform, RowsCanBeAskedForInAnyOrder)
{
  const Grid grid = randomGrid(50, 30, 0.02, 99);
  DistanceTransform transform(grid.cells, grid.columns, 225);
  NearestRow last;
  NearestRow first;
  NearestRow again;
  transform.row(29, last);
  transform.row(0, first);
  transform.row(29, again);
  EXPECT_EQ(last.squared, again.squared);
  EXPECT_EQ(last.dx, again.dx);
  EXPECT_NE(last.squared, first.squared);
}

TEST(DistanceTransform, RefusesPartsOfRowsAndReachesThatAreNone)
{
  const std::vector<uint8_t> cells(12);
  EXPECT_THROW(DistanceTransform(cells, 5, 100), std::invalid_argument);
  EXPECT_THROW(DistanceTransform(cells, 0, 100), std::invalid_argument);
  EXPECT_THROW(DistanceTransform(cells, -4, 100), std::invalid_argument);
  EXPECT_THROW(DistanceTransform(cells, 4, -1), std::invalid_argument);
  EXPECT_THROW(DistanceTransform(cells, 4, 16383 * 16383 + 1), std::invalid_argument);
  EXPECT_EQ(DistanceTransform({}, 4, 100).rows(), 0);
}
}  // namespace
