// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/navigation/footprint.h>
#include <traverse/navigation/planner.h>

#include <gtest/gtest.h>

#include <cmath>
#include <support/car.h>
#include <support/costmap_pictures.h>

namespace
{
using namespace traverse;
using namespace traverse::navigation;
using namespace traverse::testing;

constexpr double kQuarter = M_PI / 2;

double straight_m(const geometry::Pose2& a, const Goal& b)
{
  return std::hypot(b.x_m - a.x_m, b.y_m - a.y_m);
}

TEST(HybridPlan, GoesStraightAheadToWhereItLooks)
{
  const Car car;
  const Costmap map = openCostmap(60, 200);
  const geometry::Pose2 start = {2, 2, 0.5};
  const Goal goal = {2 + 8 * std::cos(0.5), 2 + 8 * std::sin(0.5), 0.5};
  const Plan plan = car.planner().plan(map, start, goal);
  ASSERT_TRUE(plan.is_whole) << plan.why_not;
  EXPECT_TRUE(plan.heeds_footprint);
  EXPECT_EQ(expectDriveable(plan.path, map, car).backward_m, 0);
  EXPECT_NEAR(plan.path.back().along_m, 8, 0.01);  // straight but for OMPL's rounding
}

TEST(HybridPlan, EndsWhereAndAsItIsTold)
{
  const Car car;
  const Costmap map = openCostmap(60, 200);
  for (int k = 0; k < 16; ++k)
  {
    const Goal goal = {6 + 4 * std::cos(k * 1.1), 6 + 4 * std::sin(k * 1.1), k * 0.9 - 3};
    const Plan plan = car.planner().plan(map, {6, 6, k * 0.7}, goal);
    ASSERT_TRUE(plan.is_whole) << plan.why_not;
    expectDriveable(plan.path, map, car);
    const geometry::Pose2& end = plan.path.back().pose;
    EXPECT_LT(straight_m(end, goal), 0.011);  // the search takes curves that meet to 1 cm
    EXPECT_NEAR(std::remainder(end.yaw_rad - *goal.yaw_rad, 2 * M_PI), 0, 0.01);
  }
}

TEST(HybridPlan, TakesAnyHeadingAtTheEndIfNoneIsAsked)
{
  const Car car;
  const Costmap map = openCostmap(60, 200);
  for (int k = 0; k < 16; ++k)
  {
    const Goal goal = {6 + 4 * std::cos(k * 0.4), 6 + 4 * std::sin(k * 0.4), {}};
    const Plan plan = car.planner().plan(map, {6, 6, 0}, goal);
    ASSERT_TRUE(plan.is_whole) << plan.why_not;
    expectDriveable(plan.path, map, car);
    EXPECT_LT(straight_m(plan.path.back().pose, goal), 1e-6);  // rounding
    // No farther than to go round a circle on the wrong side first.
    EXPECT_LT(plan.path.back().along_m, 4 + 2 * M_PI * 1.3);
  }
}

TEST(HybridPlan, DrivesForwardWhereItCan)
{
  const Car car;
  const Costmap map = openCostmap(80, 200);
  const Plan plan = car.planner().plan(map, {4, 8, 0}, {12, 10, kQuarter});
  ASSERT_TRUE(plan.is_whole);
  EXPECT_EQ(expectDriveable(plan.path, map, car).backward_m, 0);
}

TEST(HybridPlan, BacksOutOfADeadEndAndWithoutReverseFindsNoWay)
{
  Car car;
  Costmap map = openCostmap(60, 200);
  fill(map, {{20, 20}, {45, 24}}, Passage::obstacle);
  fill(map, {{20, 29}, {45, 33}}, Passage::obstacle);  // a lane 1 m wide, closed on the right
  fill(map, {{41, 20}, {45, 33}}, Passage::obstacle);
  const geometry::Pose2 start = {7, 5.3, 0};
  const Goal goal = {2, 10, {}};
  const Plan plan = car.planner().plan(map, start, goal);
  ASSERT_TRUE(plan.is_whole) << plan.why_not;
  EXPECT_GT(expectDriveable(plan.path, map, car).backward_m, 2.5);
  car.drivetrain.max_reverse_mps = 0;
  const Plan none = car.planner().plan(map, start, goal);
  EXPECT_TRUE(none.path.empty());
  EXPECT_EQ(none.why_not, "the vehicle cannot turn or does not fit on the way there");
}

TEST(HybridPlan, ParksBetweenTwoOthers)
{
  const Car car;
  Costmap map = openCostmap(50, 200);
  fill(map, {{0, 5}, {20, 9}}, Passage::obstacle);
  fill(map, {{28, 5}, {50, 9}}, Passage::obstacle);  // a gap of 1.6 m for a car of 1.0 m
  fill(map, {{0, 0}, {50, 5}}, Passage::obstacle);
  const Goal goal = {4.5, 1.4, 0};
  const Plan plan = car.planner().plan(map, {2, 3, 0}, goal);
  ASSERT_TRUE(plan.is_whole) << plan.why_not;
  const Driven driven = expectDriveable(plan.path, map, car);
  EXPECT_GT(driven.backward_m, 0.5);
  EXPECT_LE(driven.turns, 6);
  EXPECT_LT(straight_m(plan.path.back().pose, goal), 0.011);
}

TEST(HybridPlan, GoesThroughACorridorWithItsOutlineClearOfTheWalls)
{
  const Car car;
  Costmap map = openCostmap(80, 200);
  fill(map, {{0, 0}, {80, 18}}, Passage::obstacle);
  fill(map, {{0, 24}, {40, 80}}, Passage::obstacle);  // 1.2 m wide, round a corner to the left
  fill(map, {{50, 0}, {80, 80}}, Passage::obstacle);
  growBuffers(map, 0.3, 0);
  const Plan plan = car.planner().plan(map, {1, 4.2, 0}, {9, 14, kQuarter});
  ASSERT_TRUE(plan.is_whole) << plan.why_not;
  EXPECT_EQ(expectDriveable(plan.path, map, car).backward_m, 0);
  EXPECT_EQ(needsNewPlan(map, car.vehicle, plan, {1, 4.2, 0}, {}), Replan::no);
}

/** Poses of a path at which an outline with a margin would touch something. */
int touches(const Path& path, const Costmap& map, const Car& car, double margin_m)
{
  Footprint wide(car.vehicle, margin_m);
  ObstacleCounts obstacles;
  obstacles.set(map, {});
  int count = 0;
  for (const PathPoint& point : path)
  {
    count += obstacles.isHit(wide, standAt(point.pose)) ? 1 : 0;
  }
  return count;
}

TEST(HybridPlan, KeepsItsMarginWhereThereIsRoomAndDoesWithoutWhereThereIsNone)
{
  const Car car;
  Costmap map = openCostmap(60, 200);
  fill(map, {{25, 32}, {35, 33}}, Passage::obstacle);  // from y = 6.4; the car reaches to 6.35
  const geometry::Pose2 start = {2, 6.05, 0};
  const Goal goal = {10, 6.05, 0};
  const Plan plan = car.planner().plan(map, start, goal);
  ASSERT_TRUE(plan.is_whole) << plan.why_not;
  EXPECT_EQ(touches(plan.path, map, car, PlanParams().margin_m), 0);
  PlanParams without;
  without.margin_m = 0;
  const Plan straight = Planner(car.vehicle, car.drivetrain, without).plan(map, start, goal);
  EXPECT_GT(touches(straight.path, map, car, PlanParams().margin_m), 0) << "it would be near";
  fill(map, {{25, 0}, {35, 28}}, Passage::obstacle);  // 0.8 m are left, the car needs 0.6
  const Plan narrow = car.planner().plan(map, start, goal);
  ASSERT_TRUE(narrow.is_whole) << narrow.why_not;
  EXPECT_EQ(touches(narrow.path, map, car, 0), 0);
}

TEST(HybridPlan, SaysAtOnceWhereItDoesNotFit)
{
  const Car car;
  Costmap map = openCostmap(50, 200);
  fill(map, {{30, 20}, {31, 30}}, Passage::obstacle);
  fill(map, {{32, 20}, {33, 30}}, Passage::obstacle);
  const Plan plan = car.planner().plan(map, {2, 2, 0}, {6.3, 5, kQuarter});
  EXPECT_TRUE(plan.path.empty());
  EXPECT_EQ(plan.why_not, "the vehicle does not fit where the goal is");
}

TEST(HybridPlan, GivesUpAfterSoManyExpansions)
{
  Car car;
  car.drivetrain.max_reverse_mps = 0.5;
  PlanParams params;
  params.most_expansions = 2000;
  Costmap map = openCostmap(200, 200);
  fill(map, {{150, 0}, {152, 99}}, Passage::obstacle);
  fill(map, {{150, 101}, {152, 200}}, Passage::obstacle);  // a door too narrow for it
  const Plan plan =
      Planner(car.vehicle, car.drivetrain, params).plan(map, {2, 20, 0}, {38, 20, {}});
  EXPECT_TRUE(plan.path.empty());
  EXPECT_EQ(plan.why_not, "no way was found within most_expansions");
}

TEST(HybridPlan, DrivesOffFromAnObstacleThatNoiseHasPutUnderIt)
{
  const Car car;
  Costmap map = openCostmap(60, 200);
  const geometry::Pose2 start = {4, 4, 0};
  fill(map, {{23, 21}, {24, 22}}, Passage::obstacle);  // at its front left corner
  ASSERT_TRUE(touchesObstacle(map, car.vehicle, start, 0.01));
  const Plan plan = car.planner().plan(map, start, {9, 6, {}});
  ASSERT_TRUE(plan.is_whole) << plan.why_not;
  EXPECT_EQ(needsNewPlan(map, car.vehicle, plan, start, {}), Replan::no);
  EXPECT_FALSE(touchesObstacle(map, car.vehicle, plan.path.back().pose, 0));
}

TEST(HybridPlan, GoesToTheBorderTowardsAGoalBeyondIt)
{
  const Car car;
  const Costmap map = openCostmap(60, 200);
  const Plan plan = car.planner().plan(map, {6, 6, kQuarter}, {100, 6, 0});
  ASSERT_FALSE(plan.path.empty()) << plan.why_not;
  EXPECT_FALSE(plan.is_whole);
  expectDriveable(plan.path, map, car);
  EXPECT_GT(plan.path.back().pose.x_m, 10.5);  // the border is at 12 m, 1 m from it will do
}

TEST(HybridPlan, IsForAnyVehicleThatAsksForIt)
{
  PlanParams params;
  params.planner = PlannerKind::hybrid;
  const Costmap map = openCostmap(60, 200);
  const Plan plan = Planner({}, {}, params).plan(map, {2, 2, 0}, {8, 9, 1});
  EXPECT_TRUE(plan.is_whole) << plan.why_not;
  EXPECT_TRUE(plan.heeds_footprint);
}
}  // namespace
