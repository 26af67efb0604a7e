// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// What holds of every path over a grid, in random clutter.
#include <traverse/navigation/grid_path.h>
#include <traverse/navigation/planner.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <support/costmap_pictures.h>

namespace
{
using namespace traverse;
using namespace traverse::navigation;
using namespace traverse::testing;

constexpr int32_t kEdge = 80;
constexpr Place kStart = {0.93, 1.11};
constexpr Place kGoal = {14.77, 15.21};

Costmap clutter(uint32_t seed)
{
  Costmap map = clutteredCostmap(kEdge, 200, 40, seed);
  growBuffers(map, 0.25, 0.3);
  for (const Place place : {kStart, kGoal})
  {
    const geometry::CellIndex c = cellOf(place, map.lattice);
    fill(map, {{c.x - 3, c.y - 3}, {c.x + 4, c.y + 4}}, Passage::open);
  }
  return map;
}

double fieldPrice(const Costmap& map)
{
  Terrain terrain;
  terrain.set(map);
  const PriceField::Seed seed = {terrain.indexAt(kGoal), 0};
  PriceField field;
  field.start(terrain, {&seed, 1});
  const Place first = terrain.centre(terrain.indexAt(kStart));
  const Place last = terrain.centre(terrain.indexAt(kGoal));
  return field.priceFrom(terrain.indexAt(kStart)) + terrain.priceOfLine(kStart, first) +
         terrain.priceOfLine(last, kGoal);
}

TEST(GridPlan, CostsNoMoreThanTheFieldAndNoLessThanTheStraightLine)
{
  Planner planner({}, {}, {});
  int found = 0;
  for (uint32_t seed = 0; seed < 150; ++seed)
  {
    const Costmap map = clutter(seed);
    const Plan plan = planner.plan(map, {kStart.x_m, kStart.y_m, 0}, {kGoal.x_m, kGoal.y_m, {}});
    const double bound = fieldPrice(map);
    ASSERT_EQ(plan.path.empty(), !std::isfinite(bound)) << seed;
    if (plan.path.empty())
    {
      ASSERT_FALSE(plan.why_not.empty());
      continue;
    }
    ++found;
    const double dx = kGoal.x_m - kStart.x_m;
    const double dy = kGoal.y_m - kStart.y_m;
    ASSERT_LE(plan.price, bound + 1e-9) << seed;  // rounding
    ASSERT_GE(plan.price, std::sqrt(dx * dx + dy * dy) - 1e-9) << seed;
    ASSERT_GE(plan.price, plan.path.back().along_m - 1e-9) << seed;
    ASSERT_EQ(needsNewPlan(map, {}, plan, {kStart.x_m, kStart.y_m, 0}, {}), Replan::no) << seed;
  }
  EXPECT_GT(found, 75);
}

TEST(GridPlan, IsInOnePieceAndTurnsGently)
{
  Planner planner({}, {}, {});
  double sum = 0;
  size_t points = 0;
  for (uint32_t seed = 0; seed < 60; ++seed)
  {
    const Costmap map = clutter(seed);
    const Plan plan = planner.plan(map, {kStart.x_m, kStart.y_m, 0}, {kGoal.x_m, kGoal.y_m, {}});
    for (size_t k = 1; k < plan.path.size(); ++k)
    {
      const PathPoint& a = plan.path[k - 1];
      const PathPoint& b = plan.path[k];
      const double dx = b.pose.x_m - a.pose.x_m;
      const double dy = b.pose.y_m - a.pose.y_m;
      ASSERT_NEAR(b.along_m - a.along_m, std::sqrt(dx * dx + dy * dy), 1e-12);
      ASSERT_LE(b.along_m - a.along_m, 0.15);  // 0.1 m, and what smoothing may draw apart
      ASSERT_FALSE(a.is_backward);
      sum += std::abs(a.curvature_1pm);
      ++points;
    }
  }
  EXPECT_LT(sum / static_cast<double>(points), 0.8);
}

TEST(GridPlan, DependsNotOnWhatWasPlannedBefore)
{
  Planner used({}, {}, {});
  for (uint32_t seed = 0; seed < 10; ++seed)
  {
    const Costmap map = clutter(seed);
    const geometry::Pose2 start = {kStart.x_m, kStart.y_m, 0};
    const Plan first = used.plan(map, start, {kGoal.x_m, kGoal.y_m, {}});
    const Plan second = Planner({}, {}, {}).plan(map, start, {kGoal.x_m, kGoal.y_m, {}});
    ASSERT_EQ(first.path.size(), second.path.size());
    for (size_t k = 0; k < first.path.size(); ++k)
    {
      ASSERT_EQ(first.path[k].pose.x_m, second.path[k].pose.x_m);
      ASSERT_EQ(first.path[k].pose.yaw_rad, second.path[k].pose.yaw_rad);
    }
  }
}
}  // namespace
