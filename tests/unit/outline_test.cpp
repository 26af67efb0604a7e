// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/geometry/frame2.h>
#include <traverse/geometry/outline.h>

#include <gtest/gtest.h>

namespace
{
using namespace traverse;
using namespace traverse::geometry;

TEST(Outline, HullOfNothingIsEmpty)
{
  EXPECT_TRUE(convexHull({}).empty());
  EXPECT_TRUE(convexHull({{1, 1}, {1, 1}}).empty());
  EXPECT_TRUE(convexHull({{0, 0}, {1, 1}, {2, 2}}).empty());
  EXPECT_EQ(convexHull({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0.5}, {0.5, 0}}).size(), 4U);
}

TEST(Outline, ContainsWhatLiesInAnyPolygonEitherWayRound)
{
  const Outline hook = {{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {0, 1}};
  const Outline back(hook.rbegin(), hook.rend());
  for (const Outline& outline : {hook, back})
  {
    EXPECT_TRUE(contains(outline, {0.5, 0.5}));
    EXPECT_TRUE(contains(outline, {2.5, 2.5}));
    EXPECT_FALSE(contains(outline, {1, 2})) << "in the hook's bend";
    EXPECT_FALSE(contains(outline, {4, 0.5}));
    EXPECT_FALSE(contains(outline, {-1, 0.5}));
  }
  EXPECT_FALSE(contains({}, {0, 0}));
}

TEST(Outline, FootprintsHaveCornersWithXAndY)
{
  Vehicle vehicle;
  vehicle.footprint_xs_m = {-1, 2, 2, -1};
  vehicle.footprint_ys_m = {-0.5, -0.5, 1};
  EXPECT_EQ(footprintOf(vehicle), (Outline{{-1, -0.5}, {2, -0.5}, {2, 1}}));
  EXPECT_EQ(halfWidth_m(vehicle), 0.75);
  vehicle.footprint_ys_m.clear();
  EXPECT_EQ(halfWidth_m(vehicle), 0);
}

TEST(Frame2, TakesPlacesOutAndBackIn)
{
  const auto frame = Frame2::of(Pose2{2, 1, kPi / 2});
  EXPECT_NEAR((frame.out(Eigen::Vector2d(1, 0)) - Eigen::Vector2d(2, 2)).norm(), 0, 1e-15);
  EXPECT_NEAR(
      (frame.in(frame.out(Eigen::Vector2d(0.3, -4))) - Eigen::Vector2d(0.3, -4)).norm(), 0, 1e-15);
  EXPECT_EQ(frame.out(Outline{{0, 0}}), (Outline{{2, 1}}));
}
}  // namespace
