// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/drawn_lidar.h"

#include <traverse/points/range_image.h>

#include <gtest/gtest.h>

#include <limits>

using traverse::layers::OccupancyState;
using traverse::testing::DrawnLidar;
using traverse::testing::DrawnUnitMap;
using traverse::testing::DrawnWorld;

namespace traverse
{
namespace
{
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

TEST(UnitMap, FreesTheGroundThatItsBeamsMeetAndNothingUnderTheSensor)
{
  DrawnUnitMap grid;
  grid.make(DrawnLidar().turn({}).view());
  // The lowest beam passes 0.25 m over the ground at 2.9 m and lands at 3.3 m.
  EXPECT_EQ(grid.rowFrom(0, 0.1, 45), "              ...............................");
  EXPECT_EQ(grid.count(OccupancyState::obstacle, {-29, -29}, {29, 29}), 0);
  EXPECT_EQ(grid.count(OccupancyState::negative, {-29, -29}, {29, 29}), 0);
  EXPECT_NEAR(grid.ground_m, 0, 0.01);  // noiseless points, a flat world
}

TEST(UnitMap, StopsAtAWall)
{
  DrawnWorld world;
  world.boxes = {{{10, -5, 0}, {10.3, 5, 3}}};
  DrawnUnitMap grid;
  grid.make(DrawnLidar().turn(world).view());
  EXPECT_EQ(
      grid.rowFrom(3, 0.1, 60), "...................................#                        ");
  EXPECT_EQ(grid.count(OccupancyState::free, {10.6, -2}, {25, 2}), 0);
}

TEST(UnitMap, SeesAPostAndTheGroundAgainBehindItsShadow)
{
  DrawnWorld world;
  world.boxes = {{{8, -0.1, 0}, {8.1, 0.2, 0.5}}};
  DrawnUnitMap grid;
  grid.make(DrawnLidar().turn(world).view());
  EXPECT_EQ(grid.stateAt(8.05, 0.1), OccupancyState::obstacle);
  EXPECT_EQ(grid.stateAt(9, 0.1), OccupancyState::unknown);
  EXPECT_EQ(grid.stateAt(10.5, 0.1), OccupancyState::free);
}

TEST(UnitMap, OneReturnBetweenTheGroundAndTheRoofIsAnObstacle)
{
  points::ScanBuffer scan = DrawnLidar().turn({});
  DrawnLidar::add({6.1, 0.1, 1.0}, 20, scan);
  DrawnLidar::add({6.1, 4.1, 0.2}, 20, scan);
  DrawnUnitMap grid;
  grid.make(scan.view());
  EXPECT_EQ(grid.stateAt(6.1, 0.1), OccupancyState::obstacle);
  EXPECT_EQ(grid.stateAt(6.1, 4.1), OccupancyState::free);  // below obstacle_height_m
}

TEST(UnitMap, AKerbUpToTheObstacleHeightIsGroundAndAHigherOneIsAnObstacle)
{
  for (const double height_m : {0.15, 0.6})
  {
    DrawnWorld world;
    world.ground = [=](double x, double) { return x > 7 ? height_m : 0; };
    DrawnUnitMap grid;
    grid.make(DrawnLidar().turn(world).view());
    const bool is_obstacle = grid.stateAt(7.1, 0.1) == OccupancyState::obstacle;
    EXPECT_EQ(is_obstacle, height_m > 0.25) << height_m;
  }
}

TEST(UnitMap, ASlopeThatTheVehicleTakesIsFreeGround)
{
  for (const double slope_deg : {-15.0, 15.0})
  {
    const double slope = geometry::tangentOf(slope_deg * geometry::kPi / 180);
    DrawnWorld world;
    world.ground = [=](double x, double) { return x * slope; };
    DrawnUnitMap grid;
    const Eigen::Vector3d axis = -Eigen::Vector3d::UnitY();
    grid.T_map_base.linear() = poses::rotationBy(slope_deg * geometry::kPi / 180, axis);
    grid.make(DrawnLidar().turn(world, grid.T_map_base).view());
    EXPECT_EQ(grid.rowFrom(4, 0.1, 30), std::string(30, '.')) << slope_deg;
    EXPECT_EQ(grid.count(OccupancyState::obstacle, {-12, -12}, {12, 12}), 0) << slope_deg;
    EXPECT_EQ(grid.count(OccupancyState::negative, {-12, -12}, {12, 12}), 0) << slope_deg;
  }
}

TEST(UnitMap, ARampThatBeginsAtOnceIsNoObstacle)
{
  const double slope = geometry::tangentOf(15 * geometry::kPi / 180);
  DrawnWorld world;
  world.ground = [=](double x, double) { return x > 6 ? (x - 6) * slope : 0; };
  DrawnUnitMap grid;
  grid.make(DrawnLidar().turn(world).view());
  EXPECT_EQ(grid.rowFrom(4, 0.1, 45), std::string(45, '.'));
}

TEST(UnitMap, LeavesOutWhatIsBeyondTheRangeOrTheFieldOfView)
{
  DrawnWorld world;
  world.boxes = {{{10, -20, 0}, {10.3, 20, 3}}};
  const points::ScanBuffer scan = DrawnLidar().turn(world);
  DrawnUnitMap grid;
  grid.sensor.range_m = 8;
  grid.sensor.first_azimuth_deg = 0;
  grid.sensor.last_azimuth_deg = 90;
  grid.make(scan.view());
  EXPECT_EQ(grid.count(OccupancyState::obstacle, {-29, -29}, {29, 29}), 0);
  EXPECT_EQ(grid.stateAt(4, 4), OccupancyState::free);
  EXPECT_EQ(grid.stateAt(4, -4), OccupancyState::unknown);
  EXPECT_EQ(grid.stateAt(-4, 4), OccupancyState::unknown);
  EXPECT_EQ(grid.stateAt(9, 1), OccupancyState::unknown);
  EXPECT_EQ(grid.counts.points + grid.counts.outside, scan.size());
  EXPECT_GT(grid.counts.outside, scan.size() / 2);
}

TEST(UnitMap, LeavesNoHolesInTheGroundThatItSees)
{
  DrawnUnitMap grid;
  grid.make(DrawnLidar().turn({}).view());
  // Rings lie so close up to 10 m that some beam is low over every cell.
  int unknown = 0;
  grid.map.cells.forEachIn(
      {grid.cellAt(-10, -10), grid.cellAt(10, 10)},
      [&](geometry::CellIndex cell, const multi_lidar_grid::UnitCell& value)
      {
        const double square = (cell.x + 0.5) * (cell.x + 0.5) + (cell.y + 0.5) * (cell.y + 0.5);
        const bool is_in_sight = square > 17 * 17 && square < 48 * 48;
        unknown += is_in_sight && value.state == OccupancyState::unknown ? 1 : 0;
      });
  EXPECT_EQ(unknown, 0);
}

TEST(UnitMap, TakesScansWithoutRings)
{
  DrawnWorld world;
  world.boxes = {{{10, -5, 0}, {10.3, 5, 3}}};
  points::ScanBuffer scan = DrawnLidar().turn(world);
  scan.ring.clear();
  DrawnUnitMap grid;
  grid.make(scan.view());
  EXPECT_EQ(grid.stateAt(10.1, 0.1), OccupancyState::obstacle);
  EXPECT_EQ(grid.rowFrom(4, 0.1, 30), std::string(30, '.'));
  EXPECT_EQ(grid.stateAt(12, 0.1), OccupancyState::unknown);
}

TEST(UnitMap, ALevelScannerFreesWhatItsBeamsPassAndItsReturnsAreObstacles)
{
  DrawnLidar scanner;
  scanner.p_base = {0, 0, 0.2};  // lower than obstacle_height_m
  scanner.rings = 1;
  scanner.lowest_deg = 0;
  DrawnWorld world;
  world.boxes = {{{8, -5, 0}, {8.2, 5, 3}}};
  DrawnUnitMap grid;
  grid.make(scanner.turn(world).view());
  EXPECT_EQ(grid.rowFrom(0, 0.1, 50), std::string(40, '.') + "#         ");
  EXPECT_EQ(grid.at(4, 0.1).up_to, 4);                        // 0.2 m
  EXPECT_EQ(grid.stateAt(-4, 0.1), OccupancyState::unknown);  // no return
}

TEST(UnitMap, BeamsWithoutReturnFreeOnlyWhereTheSensorMay)
{
  points::RangeImage image;
  image.rows = 1;
  image.columns = 720;
  image.max_range_m = 30;
  image.beam.assign(720, points::Beam::no_return);
  image.range_m.assign(720, kNan);
  image.elevation_rad.assign(720, 0);
  for (int i = 0; i < 720; ++i)
  {
    image.azimuth_rad.push_back(static_cast<float>((i - 360) * geometry::kPi / 360));
  }
  points::ScanBuffer buffer;
  buffer.T_base_sensor.translation() = Eigen::Vector3d(0, 0, 0.2);
  points::Scan scan = buffer.view();
  scan.image = &image;
  for (const bool may : {false, true})
  {
    DrawnUnitMap grid;
    grid.params.clearing_range_m = 10;
    grid.sensor.clears_without_return = may;
    grid.make(scan);
    EXPECT_EQ(grid.stateAt(-6, 6), may ? OccupancyState::free : OccupancyState::unknown);
    EXPECT_EQ(grid.stateAt(8, 8), OccupancyState::unknown);
  }
}

TEST(UnitMap, SkipsAndCountsBadPoints)
{
  points::ScanBuffer scan = DrawnLidar().turn({});
  const size_t good = scan.size();
  for (const float bad : {kNan, kInf, -kInf, 1e30F, -1e30F})
  {
    DrawnLidar::add({bad, 0, 0}, 3, scan);
    DrawnLidar::add({0, bad, 0}, 3, scan);
    DrawnLidar::add({5, 0, bad}, 65535, scan);
  }
  scan.time_s.assign(scan.size(), 0);
  for (size_t i = 0; i < scan.size(); i += 7)
  {
    scan.time_s[i] = i % 2 == 0 ? kNan : 1e30F;
  }
  DrawnUnitMap grid;
  grid.make(scan.view());
  EXPECT_EQ(grid.counts.bad_points, 15U);
  EXPECT_EQ(grid.counts.points + grid.counts.outside, good);
  EXPECT_EQ(grid.stateAt(5, 5), OccupancyState::free);
}

TEST(UnitMap, TheSameMapIsMadeAgainAndElsewhere)
{
  DrawnWorld world;
  world.boxes = {{{5, 1, 0}, {6, 2, 2}}};
  const points::ScanBuffer scan = DrawnLidar().turn(world);
  DrawnUnitMap near;
  near.make(scan.view());
  DrawnUnitMap far;
  far.T_map_base.translation() = Eigen::Vector3d(1e7, -1e7, 300);
  far.make(scan.view());
  int different = 0;
  near.map.cells.forEach(
      [&](geometry::CellIndex cell, const multi_lidar_grid::UnitCell& value)
      {
        const geometry::CellIndex there = {cell.x + 50'000'000, cell.y - 50'000'000};
        different += far.map.cells.at(there).state == value.state ? 0 : 1;
      });
  EXPECT_EQ(different, 0);
}
}  // namespace
}  // namespace traverse
