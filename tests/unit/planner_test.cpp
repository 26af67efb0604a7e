// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/geometry/exact_trig.h>
#include <traverse/navigation/cell_walk.h>
#include <traverse/navigation/planner.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <support/costmap_pictures.h>

namespace
{
using namespace traverse;
using namespace traverse::navigation;
using namespace traverse::testing;
using Picture = std::vector<std::string>;

Planner gridPlanner()
{
  return {{}, {}, {}};
}

Plan planned(const Picture& picture, const geometry::Pose2& start, const Goal& goal)
{
  return gridPlanner().plan(drawnCostmap(picture, 200), start, goal);
}

bool touches(const Plan& plan, const Costmap& map, Passage passage)
{
  for (const PathPoint& p : plan.path)
  {
    if (map.passageAt(cellOf({p.pose.x_m, p.pose.y_m}, map.lattice)) == passage)
    {
      return true;
    }
  }
  return false;
}

TEST(Planner, GoesStraightOverOpenGround)
{
  const Plan plan = gridPlanner().plan(openCostmap(50, 200), {1.03, 2.11, 1}, {8.5, 7.2, {}});
  ASSERT_FALSE(plan.path.empty()) << plan.why_not;
  EXPECT_TRUE(plan.is_whole);
  EXPECT_EQ(plan.path.front().pose.x_m, 1.03);
  EXPECT_EQ(plan.path.back().pose.y_m, 7.2);
  const double straight_m = std::sqrt(7.47 * 7.47 + 5.09 * 5.09);
  EXPECT_NEAR(plan.price, straight_m, 1e-9);  // rounding
  EXPECT_NEAR(plan.path.back().along_m, straight_m, 1e-9);
  for (size_t k = 1; k < plan.path.size(); ++k)
  {
    const double step_m = plan.path[k].along_m - plan.path[k - 1].along_m;
    EXPECT_GT(step_m, 0.05);
    EXPECT_LE(step_m, 0.1 + 1e-9);
    EXPECT_NEAR(plan.path[k - 1].curvature_1pm, 0, 1e-9);
  }
}

TEST(Planner, LooksAlongItsPathAndAtTheEndWhereItIsTold)
{
  const Plan plan = gridPlanner().plan(openCostmap(30, 200), {1, 1, 0}, {1, 4, -3.0});
  ASSERT_GT(plan.path.size(), 2U);
  EXPECT_NEAR(plan.path.front().pose.yaw_rad, geometry::kPi / 2, 1e-12);
  EXPECT_NEAR(plan.path.back().pose.yaw_rad, -3.0, 1e-12);
}

TEST(Planner, KeepsOutOfSoftCellsAsLongAsItIsInNone)
{
  const Picture picture = {
      "............",  //
      "............",  //
      ".ssssssssss.",  //
      ".sHHHHHHHHs.",  //
      ".sH######Hs.",  //
      ".sHHHHHHHHs.",  //
      ".ssssssssss.",  //
      "............"};
  const Costmap map = drawnCostmap(picture, 200);
  const Plan plan = gridPlanner().plan(map, {1.1, 0.1, 0}, {1.1, 1.5, {}});
  ASSERT_TRUE(plan.is_whole) << plan.why_not;
  EXPECT_FALSE(touches(plan, map, Passage::soft));
  EXPECT_EQ(needsNewPlan(map, {}, plan, {1.1, 0.1, 0}, {}), Replan::no);
}

TEST(Planner, GetsOutOfASoftBufferAndIntoOne)
{
  const Picture picture = {
      "....sss",  //
      "....sss",  //
      "sss....",  //
      "sss....",
  };
  const Costmap map = drawnCostmap(picture, 200);
  const Plan plan = gridPlanner().plan(map, {0.1, 0.1, 0}, {1.3, 0.7, {}});
  ASSERT_TRUE(plan.is_whole) << plan.why_not;
  EXPECT_TRUE(touches(plan, map, Passage::soft));
  EXPECT_TRUE(touches(plan, map, Passage::open));
}

TEST(Planner, DoesNotPassASoftTunnelFromOutside)
{
  const Picture picture = {
      "..#######..",  //
      "..sssssss..",  //
      "..#######..",
  };
  const Plan plan = planned(picture, {0.1, 0.3, 0}, {2.1, 0.3, {}});
  EXPECT_TRUE(plan.path.empty());
  EXPECT_EQ(plan.why_not, "no way leads there");
}

TEST(Planner, SlipsNotBetweenTwoCellsThatTouchAtTheirCorners)
{
  const Picture picture = {
      "..#",  //
      ".#.",  //
      "#..",
  };
  EXPECT_TRUE(planned(picture, {0.1, 0.5, 0}, {0.5, 0.1, {}}).path.empty());
}

TEST(Planner, SaysWhyAGoalCannotBeReached)
{
  const Picture picture = {
      ".....#",  //
      "....HH",  //
      "......",
  };
  EXPECT_EQ(
      planned(picture, {0.1, 0.1, 0}, {1.1, 0.5, {}}).why_not, "the goal lies in an obstacle");
  EXPECT_EQ(
      planned(picture, {0.1, 0.1, 0}, {0.9, 0.3, {}}).why_not,
      "the goal lies in the hard buffer of an obstacle");
  EXPECT_EQ(
      planned(picture, {-5, 0.1, 0}, {0.9, 0.1, {}}).why_not, "the vehicle is outside the costmap");
}

TEST(Planner, LeavesAHardBufferAwayFromWhatItSurrounds)
{
  const Picture picture = {
      "#HHss......",  //
      "#HHss......",  //
      "#HHss......",  //
  };
  const Costmap map = drawnCostmap(picture, 200);
  const geometry::Pose2 start = {0.3, 0.3, 0};
  const Plan plan = gridPlanner().plan(map, start, {2.1, 0.3, {}});
  ASSERT_TRUE(plan.is_whole) << plan.why_not;
  EXPECT_GT(plan.way_out_m, 0.2);
  EXPECT_LT(plan.way_out_m, 0.45);  // hard ends after 0.3 m, a point stands every 0.1 m
  EXPECT_EQ(needsNewPlan(map, {}, plan, start, {}), Replan::no);
}

TEST(Planner, DoesNotSqueezeThroughAGapBecauseItStandsInItsHardBuffer)
{
  const Picture picture = {
      "......#......",  //
      ".....HHH.....",  //
      ".....HHH.....",  //
      "......#......",
  };
  const Plan plan = planned(picture, {1.1, 0.3, 0}, {2.3, 0.3, {}});
  EXPECT_TRUE(plan.path.empty());
}

TEST(Planner, GetsOutOfAnObstacleThatNoiseHasPutUnderIt)
{
  const Picture picture = {
      "..........",  //
      ".HHH......",  //
      ".H#H......",  //
      ".HHH......",  //
      "..........",
  };
  EXPECT_TRUE(planned(picture, {0.5, 0.5, 0}, {1.5, 0.5, {}}).is_whole);
}

TEST(Planner, GoesTowardsAGoalBeyondTheBorderByTheWayThatIsCheapestInAll)
{
  const Picture picture = {
      "##########",  //
      "..........",  //
      ".........#",  //
      ".........#",  //
      "##########"};
  const Plan plan = planned(picture, {0.5, 0.5, 0}, {50, 0.3, {}});
  ASSERT_FALSE(plan.path.empty()) << plan.why_not;
  EXPECT_FALSE(plan.is_whole);
  EXPECT_NEAR(plan.path.back().pose.x_m, 1.9, 1e-9);  // the middle of the only cell there
  EXPECT_NEAR(plan.path.back().pose.y_m, 0.7, 1e-9);
}

TEST(Planner, ThinksOfWhatIsBeyondTheBorderAsOfWhatItSees)
{
  // To the border on the left it is 2 m, to that on the right 6 m; the goal lies 50 m to the right.
  const Picture picture(21, "4444444444444444444444444444444444444444");
  const Plan plan = planned(picture, {2, 2.1, 0}, {50, 2.1, {}});
  ASSERT_FALSE(plan.path.empty()) << plan.why_not;
  EXPECT_NEAR(plan.path.back().pose.x_m, 7.9, 1e-9);
}

TEST(Planner, GoesThroughTheUnknownOrToItsEdge)
{
  const Picture picture = {
      ".....     ",  //
      ".....   . ",  //
      ".....     ",
  };
  Costmap map = drawnCostmap(picture, 200);
  const Goal goal = {1.7, 0.3, {}};
  EXPECT_TRUE(gridPlanner().plan(map, {0.1, 0.3, 0}, goal).is_whole);
  map.is_unknown_planned = false;
  EXPECT_EQ(gridPlanner().plan(map, {0.1, 0.3, 0}, goal).why_not, "no way leads there");
  const Plan plan = gridPlanner().plan(map, {0.1, 0.3, 0}, {1.3, 0.3, {}});
  EXPECT_FALSE(plan.is_whole);
  ASSERT_FALSE(plan.path.empty()) << plan.why_not;
  EXPECT_NEAR(plan.path.back().pose.x_m, 0.9, 1e-9);
}

TEST(Planner, RefusesWhatIsNoPlaceAndNoCostmap)
{
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  constexpr double kFar = 1e300;
  Planner planner = gridPlanner();
  Costmap map = openCostmap(10, 200);
  EXPECT_FALSE(planner.plan(map, {kNone, 0, 0}, {1, 1, {}}).why_not.empty());
  EXPECT_FALSE(planner.plan(map, {1, 1, kNone}, {1, 1, {}}).why_not.empty());
  EXPECT_FALSE(planner.plan(map, {1, 1, 0}, {1, kFar, {}}).why_not.empty());
  EXPECT_FALSE(planner.plan(map, {1, 1, 0}, {1, 1.5, kNone}).why_not.empty());
  EXPECT_FALSE(planner.plan({}, {1, 1, 0}, {1, 1.5, {}}).why_not.empty());
  map.price[55] = std::numeric_limits<float>::quiet_NaN();
  map.price[56] = std::numeric_limits<float>::infinity();
  EXPECT_TRUE(planner.plan(map, {0.1, 0.1, 0}, {1.9, 1.9, {}}).is_whole);
  EXPECT_FALSE(planner.plan(map, {0.1, 0.1, 0}, {1.1, 1.1, {}}).is_whole);
  map.price.pop_back();
  EXPECT_THROW(planner.plan(map, {1, 1, 0}, {1, 1.5, {}}), std::invalid_argument);
}

TEST(Planner, StaysWhereItIsIfThatIsTheGoal)
{
  const Plan plan = gridPlanner().plan(openCostmap(10, 200), {1, 1, 0}, {1, 1, {}});
  EXPECT_TRUE(plan.is_whole);
  EXPECT_EQ(plan.price, 0);
}
}  // namespace
