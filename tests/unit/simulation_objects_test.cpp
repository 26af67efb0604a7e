// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/simulation/build.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <support/scene_words.h>

namespace
{
using namespace traverse;
using namespace traverse::simulation;
using namespace traverse::testing;

constexpr double kFloat_m = 1e-5;  // vertices are floats of a few metres

const std::vector<ObjectKind> kAllKinds = {
    ObjectKind::box,   ObjectKind::prism,    ObjectKind::cylinder,   ObjectKind::hemisphere,
    ObjectKind::wall,  ObjectKind::building, ObjectKind::fence_wire, ObjectKind::fence_board,
    ObjectKind::grass, ObjectKind::lumps,    ObjectKind::bush,       ObjectKind::tree,
    ObjectKind::pole,  ObjectKind::vehicle,  ObjectKind::person,     ObjectKind::bridge,
    ObjectKind::gate,  ObjectKind::table};

ObjectParams anyOf(ObjectKind kind)
{
  ObjectParams p = objectOf(kind);
  p.x_m = 3;
  p.y_m = -2;
  p.yaw_deg = 25;
  p.seed = 7;
  if (kind == ObjectKind::prism)
  {
    p.xs_m = {0, 2, 2, 1, 0};
    p.ys_m = {0, 0, 2, 0.5, 2};
  }
  return p;
}

/** On ground that is neither level nor even. */
Scene sceneOf(const ObjectParams& object)
{
  TerrainParams hills = terrainOf(TerrainKind::hills);
  hills.wavelength_m = 8;
  SceneParams scene = sceneWith({hills});
  scene.objects = {object};
  return buildScene(scene);
}

/** Lowest and highest vertex above the ground under it. */
std::pair<double, double> overGround(const Scene& scene)
{
  double low = 1e9;
  double high = -1e9;
  const Object& object = scene.objects.at(0);
  const Eigen::Isometry3d T_map_object = object.motion.at(0);
  for (const Part& part : object.parts)
  {
    for (const Eigen::Vector3f& vertex : part.vertices)
    {
      const Eigen::Vector3d p = T_map_object * vertex.cast<double>();
      const double over = p.z() - scene.terrain->at(p.x(), p.y()).height_m;
      low = std::min(low, over);
      high = std::max(high, over);
    }
  }
  return {low, high};
}

TEST(Objects, AreClosedWhereTheyAreSolid)
{
  for (const ObjectKind kind : kAllKinds)
  {
    const Scene scene = sceneOf(anyOf(kind));
    const Object& object = scene.objects.at(0);
    EXPECT_FALSE(object.parts.empty() && object.balls.empty());
    for (const Part& part : object.parts)
    {
      if (part.solid)
      {
        EXPECT_TRUE(isClosed(part)) << options::format(kind);
        EXPECT_GT(volumeOf(part), 0) << options::format(kind) << " is inside out";
      }
    }
  }
}

TEST(Objects, StandOnTheGround)
{
  const std::set<ObjectKind> hanging = {ObjectKind::hemisphere};
  for (const ObjectKind kind : kAllKinds)
  {
    if (hanging.count(kind) == 0)
    {
      const auto [low, high] = overGround(sceneOf(anyOf(kind)));
      EXPECT_LE(low, 0.05) << options::format(kind);
      EXPECT_GT(high, 0.05) << options::format(kind);
    }
  }
}

TEST(Objects, HaveTheUsualLabelOrTheirOwn)
{
  ObjectParams tree = anyOf(ObjectKind::tree);
  EXPECT_EQ(sceneOf(tree).objects.at(0).label, Label::tree);
  tree.label = choose(Label::thing);
  EXPECT_EQ(sceneOf(tree).objects.at(0).label, Label::thing);
}

TEST(Objects, BoxHasItsSize)
{
  ObjectParams box = objectOf(ObjectKind::box);
  box.length_m = 2;
  box.width_m = 1;
  box.height_m = 0.5;
  box.z_m = 1;
  SceneParams words = sceneWith({});
  words.objects = {box};
  const Scene scene = buildScene(words);
  const Part& part = scene.objects.at(0).parts.at(0);
  EXPECT_NEAR(volumeOf(part), 1, kFloat_m);
  EXPECT_NEAR(scene.objects.at(0).motion.at(0).translation().z(), 1, kFloat_m);
}

TEST(Objects, HemisphereIsAnExactBall)
{
  ObjectParams ball = objectOf(ObjectKind::hemisphere);
  ball.radius_m = 0.7;
  const Scene scene = sceneOf(ball);
  ASSERT_EQ(scene.objects.at(0).balls.size(), 1U);
  EXPECT_EQ(scene.objects.at(0).balls.at(0).radius_m, 0.7F);
}

TEST(Objects, FenceWiresAreThinAndFollowTheGround)
{
  ObjectParams fence = anyOf(ObjectKind::fence_wire);
  fence.width_m = 0.004;
  fence.height_m = 1;
  const Scene scene = sceneOf(fence);
  size_t thin = 0;
  for (const Part& part : scene.objects.at(0).parts)
  {
    // a bar of four sides and 4 mm from corner to corner encloses 8 mm2 times its length
    thin += volumeOf(part) < 8.1e-6 * 2.6 ? 1 : 0;
  }
  EXPECT_GT(thin, 100U);
  // posts end 5 cm above the wires; between them the wires are straight over hills of 8 m
  EXPECT_NEAR(overGround(scene).second, 1.05, 0.15);
}

TEST(Objects, GrassIsLooseBladesOfTheAskedNumberAndHeight)
{
  ObjectParams grass = anyOf(ObjectKind::grass);
  grass.length_m = 3;
  grass.width_m = 2;
  grass.count = 200;
  grass.height_m = 0.3;
  const Scene scene = sceneOf(grass);
  size_t blades = 0;
  for (const Part& part : scene.objects.at(0).parts)
  {
    EXPECT_FALSE(part.solid);
    EXPECT_EQ(part.material, Material::grass);
    blades += part.triangles.size();
  }
  EXPECT_EQ(blades, 1200U);
  EXPECT_EQ(scene.objects.at(0).parts.size(), 6U);
  // leaning tips lie a few cm beside their root, on other ground
  EXPECT_NEAR(overGround(scene).second, 0.3, 0.05);
}

TEST(Objects, TreesKeepTheRoomUnderTheirLeavesFree)
{
  ObjectParams tree = anyOf(ObjectKind::tree);
  tree.branch_height_m = 2.6;
  tree.branch_m = 4;
  SceneParams words = sceneWith({});
  words.objects = {tree};
  const Scene scene = buildScene(words);
  double reach = 0;
  for (const Part& part : scene.objects.at(0).parts)
  {
    for (const Eigen::Vector3f& v : part.vertices)
    {
      const double from_trunk = std::sqrt(v.x() * v.x() + v.y() * v.y());
      reach = std::max(reach, static_cast<double>(v.x()));
      if (from_trunk > 0.5)
      {
        EXPECT_GT(v.z(), 2.55F);
      }
    }
  }
  EXPECT_GT(reach, 4);
}

TEST(Objects, MoveAlongTheirTrackOnTheGround)
{
  ObjectParams person = objectOf(ObjectKind::person);
  person.track_xs_m = {0, 6, 6};
  person.track_ys_m = {0, 0, 3};
  person.speed_mps = 1.5;
  person.start_s = 2;
  const Scene scene = sceneOf(person);
  const Motion& motion = scene.objects.at(0).motion;
  const auto at = [&](double t_s) -> Eigen::Vector3d { return motion.at(t_s).translation(); };
  EXPECT_NEAR(at(0).x(), 0, kFloat_m);
  EXPECT_NEAR(at(4).x(), 3, kFloat_m);
  EXPECT_NEAR(at(7).y(), 1.5, kFloat_m);
  EXPECT_NEAR(at(99).y(), 3, kFloat_m);
  EXPECT_NEAR(motion.at(4).linear()(0, 0), 1, kFloat_m);  // looks along the track
  EXPECT_NEAR(motion.at(7).linear()(1, 0), 1, kFloat_m);
  for (const double t : {2.0, 3.5, 5.1, 7.3})
  {
    EXPECT_NEAR(at(t).z(), scene.terrain->at(at(t).x(), at(t).y()).height_m, 1e-9);
  }
}

TEST(Objects, VehiclesLeanAsTheGroundDoes)
{
  TerrainParams ramp = terrainOf(TerrainKind::ramp);
  ramp.x_m = -10;
  ramp.length_m = 20;
  ramp.height_m = 2;
  SceneParams words = sceneWith({ramp});
  words.objects = {objectOf(ObjectKind::vehicle)};
  const Scene scene = buildScene(words);
  const Eigen::Isometry3d& T_map_body = scene.objects.at(0).motion.poses().at(0).T_map_body;
  EXPECT_NEAR(T_map_body.linear()(2, 0) / T_map_body.linear()(0, 0), 0.1, 1e-9);
  EXPECT_NEAR(T_map_body.translation().z(), 1, 1e-9);
}

TEST(Objects, RefusesWithSectionAndKey)
{
  const auto refusal = [](const ObjectParams& bad) -> std::string
  {
    SceneParams words = sceneWith({});
    words.objects = {objectOf(ObjectKind::box), bad};
    try
    {
      buildScene(words);
    }
    catch (const std::runtime_error& e)
    {
      return e.what();
    }
    return "accepted";
  };
  ObjectParams prism = objectOf(ObjectKind::prism);
  prism.xs_m = {0, 1, 0, 1};
  prism.ys_m = {0, 1, 1, 0};  // crosses itself
  EXPECT_EQ(refusal(prism).substr(0, 23), "[Object_01] xs_m, ys_m ");
  ObjectParams tree = objectOf(ObjectKind::tree);
  tree.track_xs_m = {0, 1};
  EXPECT_EQ(refusal(tree).substr(0, 22), "[Object_01] track_xs_m");
  ObjectParams grass = objectOf(ObjectKind::grass);
  grass.length_m = grass.width_m = 1000;
  EXPECT_EQ(refusal(grass).substr(0, 17), "[Object_01] count");
  ObjectParams box = objectOf(ObjectKind::box);
  box.length_m = std::nan("");
  EXPECT_EQ(refusal(box).substr(0, 20), "[Object_01] length_m");
}
}  // namespace
