// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// What holds of every path of a car, in random clutter.
#include <traverse/navigation/footprint.h>
#include <traverse/navigation/planner.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <support/car.h>
#include <support/costmap_pictures.h>

namespace
{
using namespace traverse;
using namespace traverse::navigation;
using namespace traverse::testing;

Costmap clutter(uint32_t seed)
{
  Costmap map = clutteredCostmap(90, 200, 30, seed);
  growBuffers(map, 0.3, 0.3);
  for (const geometry::CellIndex c : {geometry::CellIndex{8, 8}, {80, 80}})
  {
    fill(map, {{c.x - 7, c.y - 7}, {c.x + 8, c.y + 8}}, Passage::open);
  }
  return map;
}

TEST(HybridPlanProperty, TouchesNothingIsDriveableAndStaysAPlan)
{
  const Car car;
  Planner planner = car.planner();
  int found = 0;
  int reversing = 0;
  for (uint32_t seed = 0; seed < 40; ++seed)
  {
    const Costmap map = clutter(seed);
    const geometry::Pose2 start = {1.7, 1.7, seed * 0.37};
    const Goal goal = {16.1, 16.1, seed % 2 == 0 ? std::optional<double>(seed) : std::nullopt};
    const Plan plan = planner.plan(map, start, goal);
    ASSERT_EQ(plan.path.empty(), !plan.why_not.empty());
    if (plan.path.empty())
    {
      continue;
    }
    ++found;
    reversing += expectDriveable(plan.path, map, car).backward_m > 0 ? 1 : 0;
    EXPECT_EQ(needsNewPlan(map, car.vehicle, plan, start, {}), Replan::no) << seed;
    EXPECT_GE(plan.price, plan.path.back().along_m * 0.999);  // arcs are priced by their chords
    for (const PathPoint& p : plan.path)
    {
      const Passage passage = map.passageAt(cellOf({p.pose.x_m, p.pose.y_m}, map.lattice));
      ASSERT_LT(passage, Passage::soft) << seed;
    }
  }
  EXPECT_GT(found, 20);
  EXPECT_LT(reversing, found);
}

TEST(FootprintProperty, TouchesTheCellsThatNoAxisSeparatesFromIt)
{
  std::mt19937 random(3);
  const auto any = [&random](double from, double to)
  { return from + (to - from) * static_cast<double>(random() % 100000) / 1e5; };
  int tried = 0;
  int hits = 0;
  for (int k = 0; k < 6000; ++k)
  {
    Costmap map = openCostmap(24, 200);
    const auto x = static_cast<int32_t>(random() % 24);
    const auto y = static_cast<int32_t>(random() % 24);
    fill(map, {{x, y}, {x + 1, y + 1}}, Passage::obstacle);
    geometry::Vehicle vehicle;
    vehicle.footprint_xs_m = {any(-1.5, -0.1), any(0.3, 1.5), any(0.1, 0.8), any(-0.6, 0)};
    vehicle.footprint_ys_m = {any(-0.6, 0), any(-0.6, 0.1), any(0.3, 0.9), any(0.2, 0.9)};
    if (!isConvex(outlineAt(vehicle, {})))
    {
      continue;  // the check knows convex outlines only, the planner takes the hull of others
    }
    ++tried;
    Footprint footprint(vehicle);
    ObstacleCounts counts;
    counts.set(map, {});
    const geometry::Pose2 pose = {any(1, 4), any(1, 4), any(-4, 4)};
    const bool is_hit = counts.isHit(footprint, standAt(pose));
    // 1e-9 m: rounding.
    ASSERT_TRUE(is_hit || !touchesObstacle(map, vehicle, pose, 1e-9)) << k;
    ASSERT_TRUE(!is_hit || touchesObstacle(map, vehicle, pose, -1e-9)) << k;
    hits += is_hit ? 1 : 0;
  }
  EXPECT_GT(tried, 2000);
  EXPECT_GT(hits, 100);
}
}  // namespace
