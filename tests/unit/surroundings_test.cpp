// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "../support/simple_scene.h"

#include <traverse/simulation/build.h>
#include <traverse/simulation/surroundings.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace traverse;
using namespace traverse::simulation;

constexpr double kFar_m = 10;
constexpr double kExact_m = 1e-6;  // vertices are floats
constexpr double kDitch_m = 0.1;   // a cell of a ditch, and half of its diagonal

/** 1 m long, 0.8 m wide, 1.2 m high, steps of 0.15 m. */
geometry::Vehicle robot()
{
  geometry::Vehicle vehicle;
  vehicle.height_m = 1.2;
  return vehicle;
}

double clearance(const Scene& scene, const geometry::Pose2& pose, double t_s = 0)
{
  return Surroundings(scene, robot()).clearance_m(pose, t_s, kFar_m);
}

Scene boxAt(const Eigen::Vector3f& min, const Eigen::Vector3f& max)
{
  Scene scene = traverse::testing::planeScene();
  scene.objects.push_back(traverse::testing::boxObject(min, max));
  return scene;
}

TEST(Surroundings, MeasuresFromOutlineToOutline)
{
  const Scene scene = boxAt({2, -1, -0.1F}, {3, 1, 1});
  EXPECT_NEAR(clearance(scene, {}), 1.5, kExact_m);
  EXPECT_NEAR(clearance(scene, {0, 0, M_PI / 2}), 1.6, kExact_m);            // its side looks there
  EXPECT_NEAR(clearance(scene, {0, 3.4, 0}), std::hypot(1.5, 2), kExact_m);  // corner to corner
  EXPECT_NEAR(clearance(scene, {1.5, 0, 0}), 0, kExact_m);
  EXPECT_NEAR(clearance(scene, {1.7, 0, 0}), -0.2, kExact_m);
  EXPECT_EQ(Surroundings(scene, robot()).clearance_m({}, 0, 1), 1);  // no further than asked
}

TEST(Surroundings, LeavesOutWhatHangsHigherAndWhatWheelsTake)
{
  EXPECT_EQ(clearance(boxAt({-1, -1, 1.3F}, {1, 1, 2}), {}), kFar_m);
  EXPECT_LT(clearance(boxAt({-1, -1, 1.1F}, {1, 1, 2}), {}), 0);
  EXPECT_EQ(clearance(boxAt({-1, -1, -0.1F}, {1, 1, 0.14F}), {}), kFar_m);
  EXPECT_LT(clearance(boxAt({-1, -1, -0.1F}, {1, 1, 0.16F}), {}), 0);
}

TEST(Surroundings, LeavesOutGrass)
{
  Scene scene = boxAt({-1, -1, -0.1F}, {1, 1, 0.5F});
  scene.objects.at(0).parts.at(0).material = Material::grass;
  EXPECT_EQ(clearance(scene, {}), kFar_m);
}

TEST(Surroundings, KnowsWhereThingsAreAtTheTime)
{
  Scene scene = boxAt({-0.3F, -0.2F, 0}, {0.3F, 0.2F, 1});
  Eigen::Isometry3d from = Eigen::Isometry3d::Identity();
  from.translation() = Eigen::Vector3d(5, 0, 0);
  Eigen::Isometry3d to = from;
  to.translation().y() = 4;
  to.linear() = Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  scene.objects.at(0).motion = Motion({{2, from}, {6, to}});
  EXPECT_NEAR(clearance(scene, {}, 0), 4.2, kExact_m);
  EXPECT_NEAR(clearance(scene, {0, 4, 0}, 6), 4.3, kExact_m);  // turned by a quarter
  EXPECT_NEAR(clearance(scene, {0, 4, 0}, 60), 4.3, kExact_m);
}

TEST(Surroundings, CountsDitchesDeeperThanAStep)
{
  SceneParams words;
  words.extent.min_x_m = words.extent.min_y_m = -10;
  words.extent.max_x_m = words.extent.max_y_m = 10;
  TerrainParams ditch;
  ditch.kind = TerrainKind::ditch;
  ditch.xs_m = {3, 3};
  ditch.ys_m = {-6, 6};
  ditch.width_m = 1;
  ditch.height_m = 0.5;
  ditch.edge_m = 0.01;
  words.terrains = {ditch};
  EXPECT_NEAR(clearance(buildScene(words), {}), 2.0, kDitch_m);
  EXPECT_NEAR(clearance(buildScene(words), {2.2, 0, 0}), -0.2, kDitch_m);
  EXPECT_LT(clearance(buildScene(words), {3, 0, 0}), -0.3);  // astride of it, too
  words.terrains.at(0).height_m = 0.14;
  EXPECT_EQ(clearance(buildScene(words), {3, 0, 0}), kFar_m);
}

TEST(Surroundings, IsTheOutlinesDistanceForAnyPose)
{
  // a square is what its corners and edges say: against a dense cloud of places of both
  const Scene scene = boxAt({2, -1, 0}, {3, 1, 1});
  for (int i = 0; i < 40; ++i)
  {
    const geometry::Pose2 pose{0.1 * i, -3 + 0.05 * i, 0.3 * i};
    double nearest = kFar_m;
    for (int k = 0; k < 400; ++k)
    {
      const double u = -0.5 + (k % 20) / 19.0;
      const double v = -0.4 + 0.8 * (k / 20) / 19.0;
      const double x = pose.x_m + std::cos(pose.yaw_rad) * u - std::sin(pose.yaw_rad) * v;
      const double y = pose.y_m + std::sin(pose.yaw_rad) * u + std::cos(pose.yaw_rad) * v;
      const double dx = std::max({2 - x, 0.0, x - 3});
      const double dy = std::max({-1 - y, 0.0, y - 1});
      nearest = std::min(nearest, std::hypot(dx, dy));
    }
    const double found = clearance(scene, pose);
    EXPECT_NEAR(std::max(found, 0.0), nearest, 0.03) << i;  // its places are 5 cm apart
  }
}

TEST(Surroundings, RefusesAVehicleWithoutArea)
{
  geometry::Vehicle line;
  line.footprint_xs_m = {0, 1};
  line.footprint_ys_m = {0, 0};
  EXPECT_THROW(Surroundings(traverse::testing::planeScene(), line), std::invalid_argument);
  EXPECT_THROW(Surroundings(Scene(), robot()), std::invalid_argument);
}
}  // namespace
