// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/navigation/planner.h>

#include <gtest/gtest.h>

#include <string>
#include <support/costmap_pictures.h>
#include <utility>

// Goals that look blocked. Cells of 0.2 m; the lower left one is (0, 0).
namespace
{
using namespace traverse;
using namespace traverse::navigation;
using namespace traverse::testing;
using Picture = std::vector<std::string>;

geometry::Pose2 middleOf(int column, int row)
{
  return {0.2 * column + 0.1, 0.2 * row + 0.1, 0};
}

/** The vehicle turns on the spot, and a goal is reached at half a metre. */
Plan near(const Picture& picture, const geometry::Pose2& start, const geometry::Pose2& goal)
{
  Planner planner({}, {}, {});
  return planner.planNear(drawnCostmap(picture, 200), start, {goal.x_m, goal.y_m, {}});
}

/** Column and row in which a plan ends. */
std::pair<int, int> endOf(const Plan& plan)
{
  const geometry::Pose2& end = plan.path.back().pose;
  return {static_cast<int>(end.x_m / 0.2), static_cast<int>(end.y_m / 0.2)};
}

Picture wideBlock()
{
  const std::string half(30, '.');
  return Picture(21, half + std::string(30, '#'));
}

TEST(PlanNear, ComesAsNearAsItCan)
{
  const Plan plan = near(wideBlock(), middleOf(2, 10), middleOf(50, 10));
  ASSERT_FALSE(plan.path.empty()) << plan.why_not;
  EXPECT_EQ(endOf(plan), std::pair(29, 10));
  EXPECT_FALSE(plan.is_whole);
}

TEST(PlanNear, StaysWhereItIsAsNearAsItCanBe)
{
  const Plan plan = near(wideBlock(), middleOf(28, 10), middleOf(50, 10));
  EXPECT_TRUE(plan.path.empty());
  EXPECT_EQ(plan.why_not, "it is as near to the goal as it can come");
}

TEST(PlanNear, IsNotMovedByAFlickeringCell)
{
  Picture picture = wideBlock();
  picture[2][30] = '.';  // 8 rows up and a cell on: nearer to the goal by a little
  EXPECT_TRUE(near(picture, middleOf(29, 10), middleOf(59, 14)).path.empty());
}

TEST(PlanNear, DoesNotAimAtWhatCannotBeReached)
{
  Picture picture = wideBlock();
  picture[10][50] = '.';  // an island around the goal
  const Plan plan = near(picture, middleOf(2, 10), middleOf(50, 10));
  ASSERT_FALSE(plan.path.empty()) << plan.why_not;
  EXPECT_EQ(endOf(plan), std::pair(29, 10));
}

TEST(PlanNear, LeadsOutOfHardCellsToo)
{
  Picture picture = wideBlock();
  for (std::string& row : picture)
  {
    row.replace(0, 6, "#HHHHH");
  }
  const Plan plan = near(picture, middleOf(3, 10), middleOf(50, 10));
  ASSERT_FALSE(plan.path.empty()) << plan.why_not;
  EXPECT_EQ(endOf(plan), std::pair(29, 10));
  EXPECT_NEAR(plan.way_out_m, 0.5, 0.11);  // to their border, in steps of 0.1 m
}

TEST(PlanNear, TakesACarThereByArcs)
{
  geometry::Drivetrain drivetrain;
  drivetrain.steering = geometry::Steering::ackermann;
  Planner planner({}, drivetrain, {});
  const Plan plan =
      planner.planNear(drawnCostmap(wideBlock(), 200), middleOf(5, 10), {10.1, 2.1, {}});
  ASSERT_FALSE(plan.path.empty()) << plan.why_not;
  EXPECT_TRUE(plan.heeds_footprint);
  EXPECT_GT(plan.path.back().pose.x_m, 3.5);
}
}  // namespace
