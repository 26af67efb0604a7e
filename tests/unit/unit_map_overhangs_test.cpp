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
struct Case
{
  const char* what = nullptr;
  DrawnWorld::Box box;
  bool stops_low = false;   //!< a vehicle of 1.6 m
  bool stops_high = false;  //!< one of 2.5 m
};

const Case kCases[] = {
    {"bridge at 4 m", {{12, -5, 4.0}, {16, 5, 5}}, false, false},
    {"bridge at 2.2 m", {{8, -5, 2.2}, {12, 5, 3}}, false, true},
    {"branch at 1.8 m", {{9, -2, 1.8}, {9.2, 2, 2.0}}, false, true},
    {"garage door at 2 m", {{9, -2, 2.0}, {9.1, 2, 2.4}}, false, true},
    {"table at 0.75 m", {{8, -2, 0.6}, {9, 2, 0.75}}, true, true},
    {"boom at 1 m", {{8, -3, 0.8}, {8.1, 3, 1.0}}, true, true},
};

bool stops(const Case& c, double height_m)
{
  DrawnWorld world;
  world.boxes = {c.box};
  DrawnUnitMap grid;
  grid.vehicle.height_m = height_m;
  grid.make(DrawnLidar().turn(world).view());
  const Eigen::Vector2d min = {c.box.min.x() - 0.2, -1};
  const Eigen::Vector2d max = {c.box.max.x() + 0.2, 1};
  const int obstacles = grid.count(OccupancyState::obstacle, min, max);
  const int overhangs = grid.count(OccupancyState::overhang, min, max);
  EXPECT_GT(obstacles + overhangs, 0) << c.what << " was not met";
  return obstacles > 0;
}

TEST(Overhangs, StopTheVehicleThatDoesNotFitUnder)
{
  for (const Case& c : kCases)
  {
    EXPECT_EQ(stops(c, 1.6), c.stops_low) << c.what;
    EXPECT_EQ(stops(c, 2.5), c.stops_high) << c.what;
  }
}

TEST(Overhangs, NeedABeamThatPassedBelow)
{
  // The slab's front hides what is under it.
  DrawnWorld world;
  world.boxes = {{{8, -5, 2.2}, {8.2, 5, 3}}, {{7.4, -5, 0}, {7.6, 5, 1.2}}};
  DrawnUnitMap grid;
  grid.vehicle.height_m = 1.6;
  grid.make(DrawnLidar().turn(world).view());
  EXPECT_EQ(grid.stateAt(8.1, 0.1), OccupancyState::unknown);
}

TEST(Overhangs, AFreeCellSaysUpToWhichHeight)
{
  DrawnUnitMap grid;
  grid.make(DrawnLidar().turn({}).view());
  // At 4 m the beams are 0.09 m apart, the highest with a return (1.6 degrees below the horizon) at
  // 1.79 m; at 19 m they are 0.43 m apart, so that only the lowest counts.
  EXPECT_EQ(grid.at(4, 0.1).up_to, 35);
  EXPECT_LE(grid.at(19, 0.1).up_to, 5);
}

TEST(Overhangs, AnObstacleSaysBetweenWhichHeightsItWasHit)
{
  points::ScanBuffer scan = DrawnLidar().turn({});
  DrawnLidar::add({6.1, 0.1, 0.8}, 31, scan);
  DrawnLidar::add({6.1, 0.1, 1.0}, 31, scan);
  DrawnUnitMap grid;
  grid.make(scan.view());
  EXPECT_EQ(grid.stateAt(6.1, 0.1), OccupancyState::obstacle);
  // The ground is known to a step of 5 cm.
  EXPECT_NEAR(grid.at(6.1, 0.1).hit_from, 16, 1);
  EXPECT_NEAR(grid.at(6.1, 0.1).up_to, 20, 1);
}
}  // namespace
}  // namespace traverse
