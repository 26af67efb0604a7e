// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/poses/pose_track.h>
#include <traverse/simulation/random.h>
#include <traverse/simulation/ray_caster.h>

#include <gtest/gtest.h>

#include <support/simple_scene.h>

namespace traverse::simulation
{
namespace
{
using testing::boxObject;
using testing::planeScene;

// What the room promises, 1e-5 of the way to the border (100 m), is 1e-3 m; the issue asks for 1e-4
// m.
constexpr double kExact_m = 1e-4;

Ray rayTo(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double t_s = 0)
{
  return {from, (to - from).normalized(), t_s};
}

TEST(RayCaster, MeetsAPlaneWhereItIs)
{
  const RayCaster caster(planeScene(0.5, 0.1, -0.05));
  Random random(1);
  for (int i = 0; i < 2000; ++i)
  {
    const double x = random.uniform(-60, 60);
    const double y = random.uniform(-60, 60);
    const Eigen::Vector3d on(x, y, 0.5 + 0.1 * x - 0.05 * y);
    const Eigen::Vector3d from(random.uniform(-5, 5), random.uniform(-5, 5), 9);
    const Hit hit = caster.cast(rayTo(from, on), 120);
    ASSERT_EQ(hit.object, Scene::kGround);
    EXPECT_NEAR(hit.range_m, (on - from).norm(), kExact_m);
  }
}

TEST(RayCaster, MeetsABallWhereItIs)
{
  Scene scene = planeScene();
  Object object;
  object.balls.push_back({{30, 4, 1}, 2.5F, Material::metal});
  scene.objects.push_back(object);
  const RayCaster caster(scene);
  Random random(2);
  for (int i = 0; i < 2000; ++i)
  {
    const Eigen::Vector3d towards =
        Eigen::Vector3d(random.normal(), random.normal(), std::abs(random.normal())).normalized();
    const Eigen::Vector3d on = Eigen::Vector3d(30, 4, 1) + 2.5 * towards;
    const Eigen::Vector3d from = on + 20 * towards;
    const Hit hit = caster.cast({from, -towards, 0}, 100);
    ASSERT_EQ(hit.object, Scene::kFirstObject);
    EXPECT_EQ(hit.material, Material::metal);
    EXPECT_NEAR(hit.range_m, 20, kExact_m);
    EXPECT_NEAR(hit.cos_incidence, 1, 1e-4);
  }
}

TEST(RayCaster, MeetsABoxWhereItIs)
{
  Scene scene = planeScene();
  scene.objects.push_back(boxObject({10, -2, 0}, {14, 2, 3}));
  const RayCaster caster(scene);
  const Hit front = caster.cast(rayTo({0, 0, 1}, {10, 1.5, 2}), 100);
  EXPECT_EQ(front.object, Scene::kFirstObject);
  EXPECT_NEAR(front.range_m, Eigen::Vector3d(10, 1.5, 1).norm(), kExact_m);
  const Hit beside = caster.cast(rayTo({0, 0, 1}, {10, 2.001, 1}), 100);
  EXPECT_FALSE(beside.any());
  EXPECT_FALSE(caster.cast(rayTo({0, 0, 1}, {10, 0, 1}), 9.99).any());
}

TEST(RayCaster, MovingThingsAreMetWhereTheyAreAtTheRaysOwnTime)
{
  Scene scene = planeScene();
  Object car = boxObject({-2, -1, 0}, {2, 1, 1.5});
  const Eigen::Isometry3d start(Eigen::Translation3d(20, -30, 0));
  const Eigen::Isometry3d end(Eigen::Translation3d(20, 30, 0));
  car.motion = Motion({{0, start}, {4, end}});  // 15 m/s along y
  scene.objects.push_back(car);
  const RayCaster caster(scene);
  for (int i = 0; i <= 400; ++i)
  {
    const double t_s = 0.01 * i;
    const double y = -30 + 15 * t_s;
    const Hit hit = caster.cast(rayTo({0, y, 1}, {18, y, 1}, t_s), 100);
    ASSERT_EQ(hit.object, Scene::kFirstObject) << t_s;
    EXPECT_NEAR(hit.range_m, 18, kExact_m);
    // A metre and a bit beside it there is nothing, ahead and behind.
    EXPECT_FALSE(caster.cast(rayTo({0, y + 1.002, 1}, {18, y + 1.002, 1}, t_s), 100).any());
    EXPECT_FALSE(caster.cast(rayTo({0, y - 1.002, 1}, {18, y - 1.002, 1}, t_s), 100).any());
  }
  EXPECT_TRUE(caster.cast(rayTo({0, 30, 1}, {18, 30, 1}, 100), 100).any());
  EXPECT_TRUE(caster.cast(rayTo({0, -30, 1}, {18, -30, 1}, -5), 100).any());
}

TEST(RayCaster, TheNearerOfAStandingAndAMovingThingHides)
{
  Scene scene = planeScene();
  Object near = boxObject({5, -1, 0}, {6, 1, 2});
  near.motion = Motion({{0, Eigen::Isometry3d::Identity()}, {1, Eigen::Isometry3d::Identity()}});
  scene.objects = {boxObject({10, -1, 0}, {11, 1, 2}), near};
  const RayCaster caster(scene);
  EXPECT_EQ(caster.cast(rayTo({0, 0, 1}, {20, 0, 1}), 100).object, Scene::kFirstObject + 1);
  EXPECT_EQ(caster.cast(rayTo({20, 0, 1}, {0, 0, 1}), 100).object, Scene::kFirstObject);
}

TEST(RayCaster, NoRaySlipsThroughTheGround)
{
  const RayCaster caster(planeScene(0, 0.03, 0.02));
  Random random(3);
  for (int i = 0; i < 20000; ++i)
  {
    // Where tiles meet (every 8 m from -100) and elsewhere.
    const double x = i % 2 == 0 ? -92 + 8.0 * random.index(24) : random.uniform(-99, 99);
    const double y = random.uniform(-99, 99);
    EXPECT_TRUE(caster.cast(rayTo({0, 0, 10}, {x, y, 0.03 * x + 0.02 * y}), 300).any())
        << x << " " << y;
  }
}

TEST(RayCaster, MoreGroundThanMemoryHoldsIsRefused)
{
  Scene scene = planeScene();
  EXPECT_EQ(groundVertices(scene), 25U * 25 * 33 * 33);  // tiles of 8 m, meshes of 0.25 m
  scene.area = {-2000, -2000, 2000, 2000};
  EXPECT_GT(groundVertices(scene), kMostGroundVertices);
  EXPECT_THROW(RayCaster{scene}, std::invalid_argument);
  scene.area = {-1e300, -1e300, 1e300, 1e300};
  EXPECT_THROW(RayCaster{scene}, std::invalid_argument);
}

TEST(RayCaster, ASceneWithoutGroundIsRefused)
{
  EXPECT_THROW(RayCaster{Scene{}}, std::invalid_argument);
  Scene scene = planeScene();
  scene.objects.push_back(boxObject({0, 0, 0}, {1, 1, 1}));
  scene.objects.back().parts.front().triangles.push_back({0, 1, 8});
  EXPECT_THROW(RayCaster{scene}, std::invalid_argument);
}
}  // namespace
}  // namespace traverse::simulation
