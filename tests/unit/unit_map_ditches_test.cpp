// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/drawn_lidar.h"

#include <gtest/gtest.h>

using traverse::layers::OccupancyState;
using traverse::testing::DrawnLidar;
using traverse::testing::DrawnUnitMap;
using traverse::testing::DrawnWorld;

namespace traverse
{
namespace
{
DrawnUnitMap over(std::function<double(double, double)> ground)
{
  DrawnWorld world;
  world.ground = std::move(ground);
  DrawnUnitMap grid;
  grid.make(DrawnLidar().turn(world).view());
  return grid;
}

int negatives(const DrawnUnitMap& grid)
{
  return grid.count(OccupancyState::negative, {-29, -29}, {29, 29});
}

TEST(Ditches, OneAcrossTheRoadIsNegative)
{
  const DrawnUnitMap grid = over([](double x, double) { return x > 8 && x < 9 ? -0.5 : 0; });
  EXPECT_EQ(grid.rowFrom(6, 0.1, 15), "..........vvvvv");
}

TEST(Ditches, AHoleIsNegative)
{
  const DrawnUnitMap grid =
      over([](double x, double y) { return x > 5 && x < 6.4 && y > -1 && y < 1 ? -2 : 0; });
  EXPECT_GE(grid.count(OccupancyState::negative, {5, -1}, {6.4, 1}), 40);  // of 70 cells
  // At its near edge a column of cells has returns of its own.
  EXPECT_EQ(grid.count(OccupancyState::free, {5.4, -0.8}, {6.2, 0.8}), 0);
}

TEST(Ditches, AKerbDownOfTheStatedDepthIsNegativeAndALowerOneIsNot)
{
  const DrawnUnitMap high = over([](double x, double) { return x > 7 ? -0.35 : 0; });
  EXPECT_EQ(high.stateAt(7.5, 0.1), OccupancyState::negative);
  EXPECT_EQ(high.stateAt(9.5, 0.1), OccupancyState::free);
  EXPECT_EQ(negatives(over([](double x, double) { return x > 7 ? -0.15 : 0; })), 0);
}

TEST(Ditches, ADownSlopeIsNoDitch)
{
  for (const double slope_deg : {5.0, 10.0, 15.0})
  {
    const double slope = geometry::tangentOf(slope_deg * geometry::kPi / 180);
    const DrawnUnitMap crest = over([=](double x, double) { return x > 6 ? (6 - x) * slope : 0; });
    EXPECT_EQ(negatives(crest), 0) << slope_deg;
  }
}

TEST(Ditches, AHillIsNoDitch)
{
  // A radius of 40 m: steeper than 20 degrees from 14 m on.
  const DrawnUnitMap hill = over([](double x, double y) { return -(x * x + y * y) / 80; });
  EXPECT_EQ(hill.count(OccupancyState::negative, {-13, -13}, {13, 13}), 0);
}

TEST(Ditches, AShadowIsNoDitch)
{
  DrawnWorld world;
  world.boxes = {{{6, -1, 0}, {6.5, 1, 0.8}}, {{-9, -6, 0}, {-5, -4, 1.5}}};
  DrawnUnitMap grid;
  grid.make(DrawnLidar().turn(world).view());
  EXPECT_EQ(negatives(grid), 0);
  EXPECT_EQ(grid.stateAt(7.5, 0.1), OccupancyState::unknown);
}

TEST(Ditches, AreNotSoughtWithoutADepth)
{
  DrawnWorld world;
  world.ground = [](double x, double) { return x > 8 && x < 9 ? -0.5 : 0; };
  DrawnUnitMap grid;
  grid.params.negative_depth_m = 0;
  grid.make(DrawnLidar().turn(world).view());
  EXPECT_EQ(negatives(grid), 0);
}
}  // namespace
}  // namespace traverse
