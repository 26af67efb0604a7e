// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/navigation/planner.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <support/costmap_pictures.h>

namespace
{
using namespace traverse;
using namespace traverse::navigation;
using namespace traverse::testing;

const geometry::Pose2 start = {1, 5, 0};

struct Planned
{
  Costmap map = openCostmap(50, 200);
  Plan plan = Planner({}, {}, {}).plan(map, start, {9, 5, {}});

  Replan asked(const geometry::Pose2& pose = start) const
  {
    return needsNewPlan(map, {}, plan, pose, {});
  }
};

TEST(NeedsNewPlan, FirstOfAll)
{
  EXPECT_EQ(needsNewPlan(openCostmap(9, 200), {}, {}, start, {}), Replan::first);
}

TEST(NeedsNewPlan, NotWhileNothingChanges)
{
  const Planned p;
  EXPECT_EQ(p.asked(), Replan::no);
  EXPECT_EQ(p.asked({8.9, 5.1, 0}), Replan::no);
}

TEST(NeedsNewPlan, WhenItHasStrayed)
{
  const Planned p;
  EXPECT_EQ(p.asked({4, 5.9, 0}), Replan::no);
  EXPECT_EQ(p.asked({4, 6.1, 0}), Replan::strayed);
  EXPECT_EQ(p.asked({std::numeric_limits<double>::quiet_NaN(), 5, 0}), Replan::strayed);
}

TEST(NeedsNewPlan, WhenAHardCellLiesAheadAndNotWhenItLiesBehind)
{
  Planned p;
  fill(p.map, {{20, 0}, {21, 50}}, Passage::hard);
  EXPECT_EQ(p.asked(), Replan::blocked);
  EXPECT_EQ(p.asked({5, 5, 0}), Replan::no);
}

TEST(NeedsNewPlan, BeforeTheEndOfAPathThatDoesNotReachTheGoal)
{
  Planned p;
  p.plan.is_whole = false;
  EXPECT_EQ(p.asked({6.9, 5, 0}), Replan::no);  // 8 m long
  EXPECT_EQ(p.asked({7.1, 5, 0}), Replan::finished);
}

TEST(NeedsNewPlan, ForObstaclesUnderItsFootprintWhereThePlanHeedsThem)
{
  Planned p;
  fill(p.map, {{20, 26}, {21, 27}}, Passage::obstacle);  // from 0.2 m beside the path
  EXPECT_EQ(p.asked(), Replan::no);
  p.plan.heeds_footprint = true;
  EXPECT_EQ(p.asked(), Replan::blocked);
  EXPECT_EQ(p.asked({4.1, 5, 0}), Replan::no) << "it stands on it already";
}

TEST(NeedsNewPlan, NeverForSoftCellsAndAlwaysForHardOnes)
{
  std::mt19937 random(11);
  for (int k = 0; k < 300; ++k)
  {
    Planned p;
    const auto x = static_cast<int32_t>(6 + random() % 38);
    const auto edge = static_cast<int32_t>(1 + random() % 6);
    const auto y = static_cast<int32_t>(25 - random() % static_cast<uint32_t>(edge));
    const geometry::CellRect on_path = {{x, y}, {x + edge, y + edge}};
    fill(p.map, on_path, Passage::soft);
    ASSERT_EQ(p.asked(), Replan::no);
    fill(p.map, on_path, k % 2 == 0 ? Passage::hard : Passage::obstacle);
    ASSERT_EQ(p.asked(), Replan::blocked);
  }
}
}  // namespace
