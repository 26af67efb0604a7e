// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Cells of scenes that one can judge in one's head.
#include <traverse/geometry/exact_trig.h>
#include <traverse/simulation/truth.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <support/truth_by_place.h>
#include <support/truth_scenes.h>

namespace
{
using namespace traverse;
using namespace traverse::simulation;
using namespace traverse::testing;

double inclined(double deg)
{
  return geometry::tangentOf(deg / 180 * geometry::kPi);
}

TEST(CellTruth, LevelGroundIsFlatAndFree)
{
  const TruthByPlace truth(levelScene());
  EXPECT_EQ(truth.set().extent, (geometry::CellRect{{-20, -20}, {20, 20}}));
  EXPECT_TRUE(truth.all(TrueClass::flat));
  EXPECT_EQ(truth.state(1, 1), TrueState::free);
  EXPECT_EQ(truth.object(1, 1), Scene::kGround);
  EXPECT_EQ(truth.label(1, 1), Label::ground);
  EXPECT_EQ(truth.number("truth_roughness", 1, 1), 0);
}

TEST(CellTruth, StartInAPartOfACellIsTakenFromTheNearest)
{
  Scene scene = levelScene();
  scene.area = {-4.15, -4, 4.15, 4};
  const TruthByPlace left(scene, 0, {-4.15, 0});
  EXPECT_EQ(left.set().extent.width(), 40);
  EXPECT_TRUE(left.all(TrueClass::flat));
  EXPECT_TRUE(TruthByPlace(scene, 0, {4.15, 4}).all(TrueClass::flat));
}

TEST(CellTruth, SlopeBelowTheLimitIsFlat)
{
  const double rise = inclined(19);
  const TruthByPlace truth(sceneOf([=](double x, double) { return ground(rise * x); }));
  EXPECT_TRUE(truth.all(TrueClass::flat));
  EXPECT_NEAR(truth.number("truth_slope", 1, 1), 19, 1e-3);  // heights are floats
  EXPECT_NEAR(truth.number("ground_height", 1.1, 1), rise * 1.1, 1e-5);
}

TEST(CellTruth, SlopeAboveTheLimitIsAnObstacle)
{
  const double rise = inclined(21);
  const TruthByPlace truth(sceneOf([=](double, double y) { return ground(rise * y); }));
  EXPECT_TRUE(truth.all(TrueClass::obstacle));
  EXPECT_NEAR(truth.number("truth_slope", 1, 1), 21, 1e-3);
}

TEST(CellTruth, SmoothGroundInterpolatedIsAsSampled)
{
  const auto hill = [](double x, double y) { return ground(0.03 * x * x - 0.02 * x * y); };
  const TruthByPlace sampled(sceneOf(hill, true));
  const TruthByPlace between(sceneOf(hill, false));
  // the parabola's sag within 0.2 m is 0.06 * 0.2^2 / 8 = 0.3 mm
  EXPECT_NEAR(
      sampled.number("ground_height", 1.1, -0.7), between.number("ground_height", 1.1, -0.7), 4e-4);
  EXPECT_NEAR(
      sampled.number("truth_slope", 1.1, -0.7), between.number("truth_slope", 1.1, -0.7), 0.1);
  EXPECT_TRUE(between.all(TrueClass::flat));
}

TEST(CellTruth, KerbIsChargedToItsHigherSide)
{
  const TruthByPlace truth(sceneOf([](double x, double) { return ground(x >= 1 ? 0.15 : 0); }));
  EXPECT_EQ(truth.of(0.9, 0), TrueClass::flat);
  EXPECT_EQ(truth.of(1.1, 0), TrueClass::large_roughness);
  EXPECT_NEAR(truth.number("truth_step", 1.1, 0), 0.15, 1e-6);
  EXPECT_EQ(truth.of(1.3, 0), TrueClass::flat);  // the pavement can be reached
}

TEST(CellTruth, RutsAndBanksAreMeasuredFromTheSmoothGround)
{
  const TruthByPlace truth(sceneOf(
      [](double x, double)
      {
        const double rut = std::abs(x) < 0.3 ? -0.08 : 0;
        const double bank = std::abs(x - 2) < 0.3 ? 0.2 : 0;
        return relief(rut + bank);
      }));
  EXPECT_EQ(truth.of(0.1, 0), TrueClass::small_roughness);
  EXPECT_EQ(truth.of(1.9, 0), TrueClass::large_roughness);
  EXPECT_EQ(truth.of(1, 0), TrueClass::flat);
}

TEST(CellTruth, WallFillsTheCellsThatItReachesInto)
{
  Scene scene = levelScene();
  scene.objects.push_back(boxObject({{1.0F, -1.0F, 0}, {1.6F, 1.0F, 2.0F}}, Label::wall));
  scene.objects.push_back(boxObject({{-1.05F, 0.61F, 0}, {-0.95F, 0.79F, 2.0F}}));
  const TruthByPlace truth(scene);
  EXPECT_EQ(truth.of(1.1, 0), TrueClass::obstacle);
  EXPECT_EQ(truth.state(1.5, 0.9), TrueState::occupied);
  EXPECT_EQ(truth.object(1.5, 0), Scene::kFirstObject);
  EXPECT_EQ(truth.label(1.5, 0), Label::wall);
  // walls that end on an edge of cells do not reach into the next
  EXPECT_EQ(truth.of(0.9, 0), TrueClass::flat);
  EXPECT_EQ(truth.of(1.7, 0), TrueClass::flat);
  EXPECT_EQ(truth.of(1.1, 1.1), TrueClass::flat);
  // one across an edge stands in both
  EXPECT_EQ(truth.of(-1.1, 0.7), TrueClass::obstacle);
  EXPECT_EQ(truth.of(-0.9, 0.7), TrueClass::obstacle);
  EXPECT_EQ(truth.of(-0.7, 0.7), TrueClass::flat);
}

TEST(CellTruth, FlatTopsOfThingsAreObstacles)
{
  Scene scene = levelScene();
  scene.objects.push_back(boxObject({{0.0F, 0.0F, 0.70F}, {2.0F, 2.0F, 0.75F}}, Label::structure));
  const TruthByPlace truth(scene);
  EXPECT_EQ(truth.of(1, 1), TrueClass::obstacle);
  EXPECT_NEAR(truth.number("truth_step", 1, 1), 0.75, 1e-6);
}

TEST(CellTruth, BridgeAboveTheVehicleIsAnOverhangOneBelowAnObstacle)
{
  Scene scene = levelScene();
  scene.objects.push_back(boxObject({{0, 0, 3.0F}, {2, 2, 3.5F}}, Label::structure));
  scene.objects.push_back(boxObject({{-2, -2, 1.5F}, {-1, -1, 2.0F}}, Label::structure));
  const TruthByPlace truth(scene);
  EXPECT_EQ(truth.of(1, 1), TrueClass::flat);
  EXPECT_EQ(truth.state(1, 1), TrueState::overhang);
  EXPECT_EQ(truth.object(1, 1), Scene::kGround);
  EXPECT_EQ(truth.of(-1.5, -1.5), TrueClass::obstacle);
  EXPECT_EQ(truth.state(-1.5, -1.5), TrueState::occupied);
}

TEST(CellTruth, WireIsAnObstacle)
{
  Scene scene = levelScene();
  scene.objects.push_back(
      boxObject({{0.0F, 0.5985F, 0.5F}, {2.0F, 0.6015F, 0.503F}}, Label::fence));
  const TruthByPlace truth(scene);
  EXPECT_EQ(truth.of(1, 0.5), TrueClass::obstacle);
  EXPECT_EQ(truth.of(1, 0.7), TrueClass::obstacle);
  EXPECT_EQ(truth.of(1, 0.9), TrueClass::flat);
}

TEST(CellTruth, DitchIsADitchAndAnObstacle)
{
  const TruthByPlace truth(sceneOf(
      [](double x, double)
      {
        GroundAt at = relief(x > 1 && x < 2 ? -0.6 : 0);
        at.ditch_m = -at.height_m;
        return at;
      }));
  EXPECT_EQ(truth.state(1.5, 0), TrueState::ditch);
  EXPECT_EQ(truth.of(1.5, 0), TrueClass::obstacle);
  EXPECT_EQ(truth.state(2.5, 0), TrueState::free);  // what is smooth goes on behind it
}

TEST(CellTruth, GrassIsNeverWorseThanLargeRoughness)
{
  const auto grown = [](float height_m)
  {
    Scene scene = levelScene();
    scene.objects.push_back(grassObject({{0, 0, 0}, {2, 2, 0}}, height_m));
    return TruthByPlace(scene).of(1.1, 1.1);
  };
  EXPECT_EQ(grown(0.05F), TrueClass::small_roughness);
  EXPECT_EQ(grown(0.20F), TrueClass::large_roughness);
  EXPECT_EQ(grown(0.50F), TrueClass::large_roughness);
}

TEST(CellTruth, WhatIsHardInGrassCounts)
{
  Scene scene = levelScene();
  scene.objects.push_back(grassObject({{0, 0, 0}, {2, 2, 0}}, 0.5F));
  scene.objects.push_back(boxObject({{1.0F, 1.0F, 0}, {1.2F, 1.2F, 0.4F}}, Label::thing));
  const TruthByPlace truth(scene);
  EXPECT_EQ(truth.of(1.1, 1.1), TrueClass::obstacle);
  EXPECT_EQ(truth.state(0.5, 0.5), TrueState::free);
}

TEST(CellTruth, PlatformsAndPitsThatCannotBeReachedAreObstacles)
{
  const TruthByPlace truth(sceneOf(
      [](double x, double y)
      {
        const bool inside = std::abs(x) < 1 && std::abs(y) < 1;
        const bool pit = std::abs(x - 3) < 0.5 && std::abs(y) < 0.5;
        return ground(inside ? 1.0 : pit ? -1.0 : 0.0);
      }));
  EXPECT_EQ(truth.of(0.1, 0.1), TrueClass::obstacle);
  EXPECT_EQ(truth.of(3.1, 0.1), TrueClass::obstacle);
  EXPECT_EQ(truth.of(2.1, 0.1), TrueClass::flat);
  EXPECT_EQ(truth.of(-1.1, 0.1), TrueClass::flat);  // at the platform's foot
}

TEST(CellTruth, PlatformWithARampIsReached)
{
  const TruthByPlace truth(sceneOf(
      [](double x, double) {
        return ground(x < -2 ? 0.0 : x < 1 ? (x + 2) / 3 : 1.0);
      }));  // 18.4 deg
  EXPECT_TRUE(truth.all(TrueClass::flat));
}

TEST(CellTruth, ThingsStandWhereTheyAreAtTheTime)
{
  Scene scene = levelScene();
  scene.objects.push_back(boxObject({{-0.3F, -0.3F, 0}, {0.3F, 0.3F, 1.5F}}, Label::vehicle));
  TimedPose start;
  TimedPose end;
  end.t_s = 2;
  end.T_map_body.translation().x() = 2;
  scene.objects[0].motion = Motion({start, end});
  EXPECT_EQ(TruthByPlace(scene, 0).of(0.1, 0.1), TrueClass::obstacle);
  EXPECT_EQ(TruthByPlace(scene, 2).of(0.1, 0.1), TrueClass::flat);
  EXPECT_EQ(TruthByPlace(scene, 2).of(2.1, 0.1), TrueClass::obstacle);
}

TEST(CellTruth, BallIsAsHighAsItIsOverEachCell)
{
  Scene scene = levelScene();
  Object ball;
  ball.balls.push_back({{0.1F, 0.1F, 0}, 0.5F, Material::snow});
  scene.objects.push_back(ball);
  const TruthByPlace truth(scene);
  EXPECT_NEAR(truth.number("truth_step", 0.1, 0.1), 0.5, 1e-6);
  // nearest 0.1 + 0.3 m from the axis, and 0.0005 m further (what ends on an edge ends there)
  EXPECT_NEAR(truth.number("truth_step", 0.5, 0.1), std::sqrt(0.25 - 0.3005 * 0.3005), 1e-5);
  EXPECT_EQ(truth.of(0.7, 0.1), TrueClass::flat);
}

TEST(CellTruth, GroundThatIsNotThereIsUnknown)
{
  const TruthByPlace truth(
      sceneOf([](double x, double)
              { return ground(x > 1 ? std::numeric_limits<double>::quiet_NaN() : 0.0); }));
  EXPECT_EQ(truth.of(1.5, 0), TrueClass::unknown);
  EXPECT_EQ(truth.state(1.5, 0), TrueState::unknown);
  EXPECT_EQ(truth.of(-1.5, 0), TrueClass::flat);
}

TEST(CellTruth, RefusesWhatItCannotJudge)
{
  const geometry::Vehicle vehicle;
  const TruthParams params;
  const Scene scene = levelScene();
  EXPECT_THROW(cellTruth(Scene{}, vehicle, params, 0, {0, 0}), std::invalid_argument);
  EXPECT_THROW(cellTruth(scene, vehicle, params, 0, {9, 0}), std::invalid_argument);
  TruthParams wrong;
  wrong.small_max_m = 0.02;
  EXPECT_THROW(cellTruth(scene, vehicle, wrong, 0, {0, 0}), options::OptionError);
  wrong = {};
  wrong.cell_size_m = 0.20005;
  EXPECT_THROW(cellTruth(scene, vehicle, wrong, 0, {0, 0}), options::OptionError);
  Scene endless = scene;
  endless.area = {-1e5, -1e5, 1e5, 1e5};
  EXPECT_THROW(cellTruth(endless, vehicle, params, 0, {0, 0}), std::length_error);
  Scene broken = scene;
  broken.objects.push_back(boxObject({{0, 0, 0}, {1, 1, 1}}));
  broken.objects[0].parts[0].triangles.push_back({0, 1, 8});
  EXPECT_THROW(cellTruth(broken, vehicle, params, 0, {0, 0}), std::invalid_argument);
}
}  // namespace
