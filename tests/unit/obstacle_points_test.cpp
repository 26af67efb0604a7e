// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/geometry/exact_trig.h>
#include <traverse/navigation/obstacle_points.h>

#include <gtest/gtest.h>

#include <limits>
#include <support/cost_pictures.h>

namespace
{
using namespace traverse;
using namespace traverse::navigation;
using namespace traverse::testing;

constexpr double kFar_m = 100;

TEST(ObstaclePoints, LieInTheMiddleOfCellsSeenFromTheVehicle)
{
  const Costmap costmap = costsOf({occupancyOf({"...", "..#", "..."})}, withoutBuffers());
  // The cell's middle is at (0.5, 0.3): ahead and to the right of a vehicle that looks along y.
  const auto points = obstaclePoints(costmap, {0.1, 0.1, geometry::kPi / 2}, kFar_m);
  ASSERT_EQ(points.size(), 1U);
  EXPECT_NEAR(points[0].x(), 0.2F, 1e-6F);  // rounding of floats
  EXPECT_NEAR(points[0].y(), -0.4F, 1e-6F);
  EXPECT_EQ(points[0].z(), kObstacleHeight_m);
}

TEST(ObstaclePoints, AreAsHighAsWhatStandsThere)
{
  layers::LayerSet map = classesOf({"4.4"});
  map.layers.push_back({"ground_height", "m", std::vector<float>{1, 1, 1}});
  map.layers.push_back({"height_max", "m", std::vector<float>{1.75F, 1, 0.5F}});
  const auto points = obstaclePoints(costsOf({map}, withoutBuffers()), {}, kFar_m);
  ASSERT_EQ(points.size(), 2U);
  EXPECT_EQ(points[0].z(), 0.75F);
  EXPECT_EQ(points[1].z(), kObstacleHeight_m);  // a height that is none
}

TEST(ObstaclePoints, AreOfWhatFallsAwayToo)
{
  const auto points = obstaclePoints(costsOf({occupancyOf({"v"})}, withoutBuffers()), {}, kFar_m);
  ASSERT_EQ(points.size(), 1U);
  EXPECT_EQ(points[0].z(), kObstacleHeight_m);
}

TEST(ObstaclePoints, LeaveOutWhatObstaclesSurround)
{
  const Costmap costmap =
      costsOf({occupancyOf({".....", ".###.", ".###.", ".###.", "....."})}, withoutBuffers());
  EXPECT_EQ(obstaclePoints(costmap, {}, kFar_m).size(), 8U);
}

TEST(ObstaclePoints, KeepThoseAtTheBorder)
{
  const Costmap costmap = costsOf({occupancyOf({"##", "##"})}, withoutBuffers());
  EXPECT_EQ(obstaclePoints(costmap, {}, kFar_m).size(), 4U);
}

TEST(ObstaclePoints, EndAtTheRange)
{
  const Costmap costmap = costsOf({occupancyOf({"#.#.#.#"})}, withoutBuffers());
  EXPECT_EQ(obstaclePoints(costmap, {0.1, 0.1, 0}, 0.4 + 1e-9).size(), 2U);
  EXPECT_EQ(obstaclePoints(costmap, {1.3, 0.1, 0}, 0.8 + 1e-9).size(), 3U);
  EXPECT_EQ(
      obstaclePoints(costmap, {0.1, 0.1, 0}, std::numeric_limits<double>::infinity()).size(), 4U);
  EXPECT_TRUE(obstaclePoints(costmap, {50, 50, 0}, 1).empty());
}

TEST(ObstaclePoints, AreNoneSeenFromNowhere)
{
  const Costmap costmap = costsOf({occupancyOf({"#"})}, withoutBuffers());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(obstaclePoints(costmap, {nan, 0, 0}, kFar_m).empty());
  EXPECT_TRUE(obstaclePoints(costmap, {0, 0, nan}, kFar_m).empty());
  EXPECT_TRUE(obstaclePoints(costmap, {1e300, -1e300, 0}, kFar_m).empty());
  EXPECT_TRUE(obstaclePoints(costmap, {0, 0, 0}, nan).empty());
}
}  // namespace
