// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/points/scan.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <support/occupancy_pictures.h>

namespace
{
using namespace traverse;
using namespace traverse::testing;
using namespace traverse::multi_lidar_grid;
using ::testing::HasSubstr;
using ::testing::Not;

std::string textOf(const Map& map, geometry::CellIndex cell)
{
  std::string text;
  for (const layers::Fact& fact : explain(map.state, map.params, map.vehicle, cell))
  {
    text += fact.key + ": " + fact.value + "\n";
  }
  return text;
}

TEST(MultiLidarWhy, SaysStateSensorsAndAges)
{
  Map map = smallMap();
  addCloud(map, "left", {".#"});
  addCloud(map, "right\n", {"  "}, 100);
  accumulate(map, {".#"}, 3);
  Cell& obstacle = map.state.cells.at({1, 0});
  obstacle.passes = 2;
  obstacle.hit_from = 8;
  obstacle.up_to = 20;
  const std::string text = textOf(map, {1, 0});
  EXPECT_THAT(text, HasSubstr("state: obstacle\n"));
  EXPECT_THAT(text, HasSubstr("the last 2 contradicted it; 3 clear"));
  EXPECT_THAT(text, HasSubstr("seen by: left, right"));
  EXPECT_THAT(text, HasSubstr("last hit: 2 s ago"));
  EXPECT_THAT(text, HasSubstr("hit from: 0.4 m to 1 m over the ground"));
  EXPECT_THAT(text, Not(HasSubstr("known free")));
  EXPECT_THAT(text, HasSubstr("safety_buffer: hard"));
  EXPECT_THAT(text, HasSubstr("sensor left: ok, newest cloud 0 s ago: obstacle"));
  EXPECT_THAT(text, HasSubstr("dead, newest cloud 100 s ago, which no longer counts"));
  EXPECT_THAT(textOf(map, {0, 0}), HasSubstr("known free up to: 0.25 m"));
}

TEST(MultiLidarWhy, TellsUnseenFromOutside)
{
  const Map map = smallMap();
  EXPECT_THAT(textOf(map, {0, 0}), HasSubstr("no sensor said anything of it"));
  EXPECT_THAT(textOf(map, {1000, 0}), HasSubstr("outside the map's window of 10 m"));
  const int32_t most = std::numeric_limits<int32_t>::max();
  EXPECT_THAT(textOf(map, {most, most}), HasSubstr("outside"));
}

/** A wall at x = 2 m, and points of it as seen from the map's zero. */
struct Wall
{
  Wall() : map(smallMap())
  {
    accumulate(map, {"    #", "    #", "    #", "    #"}, 1);
    for (int i = 0; i < 20; ++i)
    {
      scan.x.push_back(2.25F);
      scan.y.push_back(0.1F * static_cast<float>(i));
      scan.z.push_back(1.0F);
    }
  }

  double at(double x_m) const
  {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation().x() = x_m;
    return of(pose);
  }

  double of(const Eigen::Isometry3d& pose) const
  {
    return logLikelihood(map.state, scan.view(), pose, map.params, map.vehicle, {});
  }

  Map map;
  points::ScanBuffer scan;
};

TEST(MultiLidarLikelihood, IsBestWhereTheObstaclesAre)
{
  const Wall wall;
  EXPECT_EQ(wall.at(0), 0);
  EXPECT_LT(wall.at(0.5), wall.at(0));
  EXPECT_LT(wall.at(1.0), wall.at(0.5));
  // From the cell's edge at 2.5 m the points lie 0.25 m away: -0.25^2 / (2 * 0.3^2) each.
  EXPECT_NEAR(wall.at(0.5), -20 * 0.25 * 0.25 / (2 * 0.09), 1e-6);  // float points
}

TEST(MultiLidarLikelihood, OfFarPointsIsTheWorst)
{
  const Wall wall;
  EXPECT_DOUBLE_EQ(wall.at(1e6), -20 * LikelihoodParams{}.worst);
}

TEST(MultiLidarLikelihood, LooksAtNoMorePointsThanAsked)
{
  const Wall wall;
  LikelihoodParams five;
  five.max_points = 5;
  Eigen::Isometry3d far = Eigen::Isometry3d::Identity();
  far.translation().x() = 1000;
  const double sum =
      logLikelihood(wall.map.state, wall.scan.view(), far, wall.map.params, wall.map.vehicle, five);
  EXPECT_DOUBLE_EQ(sum, -5 * five.worst);
}

TEST(MultiLidarLikelihood, LeavesGroundAndWhatHangsOverOut)
{
  Wall wall;
  for (float& z : wall.scan.z)
  {
    z = &z - wall.scan.z.data() < 10 ? 0.1F : 2.5F;
  }
  EXPECT_EQ(wall.at(1), 0);
}

TEST(MultiLidarLikelihood, IsZeroForWhatIsNone)
{
  Wall wall;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation().x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(wall.of(pose), 0);
  pose = Eigen::Isometry3d::Identity();
  pose.linear() *= 3;
  EXPECT_EQ(wall.of(pose), 0);
  EXPECT_EQ(wall.at(1e300), 0);
  wall.scan.x.assign(20, std::numeric_limits<float>::infinity());
  EXPECT_EQ(wall.at(0), 0);
  wall.map.state.robot.reset();
  EXPECT_EQ(wall.at(1), 0);
}
}  // namespace
