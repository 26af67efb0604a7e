// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "../support/simple_scene.h"

#include <traverse/simulation/drive.h>
#include <traverse/simulation/vehicle_model.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
using namespace traverse;
using namespace traverse::simulation;
using geometry::Drivetrain;
using geometry::Steering;
using geometry::Twist2;

constexpr double kGravity = 9.81;
constexpr double kDegree = M_PI / 180;

Drivetrain carLike()
{
  Drivetrain drivetrain;
  drivetrain.steering = Steering::ackermann;
  return drivetrain;
}

VehicleModel modelOn(
    Material material, const Drivetrain& drivetrain, const geometry::Pose2& start = {})
{
  return VehicleModel(
      std::make_shared<traverse::testing::Floor>(material), geometry::Vehicle(), drivetrain, start);
}

double distance(const geometry::Pose2& a, const geometry::Pose2& b)
{
  return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m);
}

/** Radius of the circle through three places. */
double radiusThrough(const geometry::Pose2& a, const geometry::Pose2& b, const geometry::Pose2& c)
{
  const double twice_area =
      std::abs((b.x_m - a.x_m) * (c.y_m - a.y_m) - (b.y_m - a.y_m) * (c.x_m - a.x_m));
  return distance(a, b) * distance(b, c) * distance(c, a) / (2 * twice_area);
}

double steadyRadius(VehicleModel model, const Twist2& command)
{
  model.step(command, 5);  // until it has its speed and its steering
  const geometry::Pose2 a = model.state().pose;
  model.step(command, 1);
  const geometry::Pose2 b = model.state().pose;
  model.step(command, 1);
  EXPECT_FALSE(model.state().slips);
  return radiusThrough(a, b, model.state().pose);
}

/** Way from the command to stop until it stands. */
double stoppingWay(VehicleModel& model, double speed_mps)
{
  model.step({speed_mps, 0}, 10);
  EXPECT_DOUBLE_EQ(model.state().twist.speed_mps, speed_mps);
  const geometry::Pose2 from = model.state().pose;
  for (int i = 0; i < 5000 && model.state().twist.speed_mps > 0; ++i)
  {
    model.step({0, 0}, 0.01);
  }
  return distance(from, model.state().pose);
}

// Arcs are trapezoids of 10 ms: of a turn of 0.01 rad the radius errs by 1e-5 of itself.
constexpr double kArc = 1e-4;

TEST(VehicleModel, DrivesCirclesOfTheCommandedRadius)
{
  EXPECT_NEAR(steadyRadius(modelOn(Material::asphalt, {}), {1, 0.5}), 2, 2 * kArc);
  EXPECT_NEAR(steadyRadius(modelOn(Material::asphalt, {}), {-0.5, 0.25}), 2, 2 * kArc);
  EXPECT_NEAR(steadyRadius(modelOn(Material::asphalt, carLike()), {1, -0.4}), 2.5, 2.5 * kArc);
}

TEST(VehicleModel, ACarTurnsNoTighterThanItsSteeringAllows)
{
  const double tightest = 0.6 / std::tan(30 * kDegree);
  EXPECT_NEAR(
      steadyRadius(modelOn(Material::asphalt, carLike()), {1, 5}), tightest, tightest * kArc);
  EXPECT_NEAR(geometry::minTurningRadius_m(carLike()), tightest, 1e-12);
}

TEST(VehicleModel, TurnsTheSameWayBackward)
{
  VehicleModel model = modelOn(Material::asphalt, carLike());
  model.step({-0.5, 0.3}, 1);
  EXPECT_LT(model.state().steer_rad, 0);  // to turn left backward it steers right
  EXPECT_GT(model.state().pose.yaw_rad, 0);
  EXPECT_LT(model.state().pose.x_m, 0);
}

TEST(VehicleModel, StopsWithinItsBrakingWay)
{
  Drivetrain drivetrain;
  drivetrain.max_speed_mps = 4;
  drivetrain.max_decel_mps2 = 2;
  VehicleModel model = modelOn(Material::asphalt, drivetrain);
  EXPECT_NEAR(stoppingWay(model, 4), 4.0 * 4.0 / (2 * 2), 1e-9);  // a whole number of steps: exact
  EXPECT_FALSE(model.state().slips);
}

TEST(VehicleModel, StopsOnIceWithinTheWayThatFrictionAllows)
{
  Drivetrain drivetrain;
  drivetrain.max_speed_mps = 4;
  drivetrain.max_accel_mps2 = 0.5;  // less than ice gives
  VehicleModel model = modelOn(Material::ice, drivetrain);
  const double way = 4.0 * 4.0 / (2 * frictionOf(Material::ice) * kGravity);
  EXPECT_NEAR(stoppingWay(model, 4), way, 1e-4);  // the last step of 10 ms is not whole
}

TEST(VehicleModel, WheelsSpinOnIceWhereTheCommandAsksTooMuch)
{
  Drivetrain drivetrain;
  drivetrain.max_speed_mps = 2;
  drivetrain.max_accel_mps2 = 2;
  VehicleModel model = modelOn(Material::ice, drivetrain);
  model.step({2, 0}, 1);
  EXPECT_TRUE(model.state().slips);
  EXPECT_DOUBLE_EQ(model.state().wheels.speed_mps, 2);
  EXPECT_NEAR(model.state().twist.speed_mps, frictionOf(Material::ice) * kGravity, 1e-9);
}

TEST(VehicleModel, SlidesOutOfACurveThatIsTooFast)
{
  Drivetrain drivetrain;
  drivetrain.max_speed_mps = 2;
  drivetrain.max_accel_mps2 = 0.5;
  const Twist2 curve{2, 1};  // 2 m/s2 to the side, twice of what ice gives
  EXPECT_NEAR(steadyRadius(modelOn(Material::asphalt, drivetrain), curve), 2, 2 * kArc);
  VehicleModel model = modelOn(Material::ice, drivetrain);
  model.step({2, 0}, 5);
  const geometry::Pose2 from = model.state().pose;
  model.step(curve, 1);
  EXPECT_TRUE(model.state().slips);
  EXPECT_LT(model.state().aside_mps, -0.05);  // to the outer side of a left curve
  const double aside_m = model.state().pose.y_m - from.y_m;
  // friction alone could move it by mu g t^2 / 2 at most
  EXPECT_LE(aside_m, frictionOf(Material::ice) * kGravity / 2 + 1e-9);
}

TEST(VehicleModel, SteersAsFastAsItsSteeringGoes)
{
  VehicleModel model = modelOn(Material::asphalt, carLike());
  model.step({0.5, 2}, 0.25);
  EXPECT_NEAR(model.state().steer_rad, 60 * kDegree * 0.25, 1e-12);
  model.step({0.5, 2}, 1);
  EXPECT_NEAR(model.state().steer_rad, 30 * kDegree, 1e-12);
  model.step({0, 2}, 1);  // no speed: what it steers says nothing
  EXPECT_NEAR(model.state().steer_rad, 30 * kDegree, 1e-12);
}

TEST(VehicleModel, KeepsToTheLimitsOfItsDrivetrain)
{
  VehicleModel model = modelOn(Material::asphalt, {});
  model.step({100, -100}, 0.5);
  EXPECT_NEAR(model.state().twist.speed_mps, 0.5, 1e-12);  // 1 m/s2
  model.step({100, -100}, 5);
  EXPECT_DOUBLE_EQ(model.state().twist.speed_mps, 1);
  EXPECT_DOUBLE_EQ(model.state().twist.yaw_rate_radps, -60 * kDegree);
  model.step({-100, 0}, 5);
  EXPECT_DOUBLE_EQ(model.state().twist.speed_mps, -0.5);
  EXPECT_DOUBLE_EQ(model.state().twist.yaw_rate_radps, 0);
}

TEST(VehicleModel, TurnsOnTheSpot)
{
  VehicleModel model = modelOn(Material::asphalt, {}, {3, 4, 1});
  model.step({0, 0.5}, 2);
  EXPECT_NEAR(distance(model.state().pose, {3, 4, 0}), 0, 1e-12);
  EXPECT_GT(model.state().pose.yaw_rad, 1.9);
}

TEST(VehicleModel, StandsOnASlopeAndSlidesDownAnIcyOne)
{
  const double slope = std::tan(12 * kDegree);
  for (const Material material : {Material::soil, Material::ice})
  {
    VehicleModel model(
        std::make_shared<traverse::testing::Floor>(material, slope), geometry::Vehicle(),
        Drivetrain(), {});
    model.step({0, 0}, 1);
    // g (sin - mu cos), half of that in a second, less by cos as seen from above
    const double accel = kGravity * (std::sin(12 * kDegree) - 0.1 * std::cos(12 * kDegree));
    const double way = material == Material::ice ? accel / 2 * std::cos(12 * kDegree) : 0;
    EXPECT_NEAR(model.state().pose.x_m, -way, 1e-6) << nameOf(material);
    EXPECT_EQ(model.state().slips, material == Material::ice);
  }
}

TEST(VehicleModel, StandsOnThePlaneUnderIt)
{
  geometry::Vehicle vehicle;
  vehicle.base_height_m = 0.2;
  const auto terrain = std::make_shared<traverse::testing::PlaneTerrain>(5, 0.1, -0.05);
  VehicleModel model(terrain, vehicle, {}, {});
  model.step({1, 0}, 3);
  DriveParams line;
  line.xs_m = {0, 20};
  line.ys_m = {0, 0};
  const Motion drive = driveOn(*terrain, line, vehicle);
  const Eigen::Isometry3d stand = model.T_map_base();
  EXPECT_LT((stand.linear() - drive.at(0).linear()).norm(), 1e-9);
  const Eigen::Vector3d foot = stand.translation() - 0.2 * stand.linear().col(2);
  EXPECT_NEAR(foot.z(), 5 + 0.1 * foot.x() - 0.05 * foot.y(), 1e-6);
}

TEST(VehicleModel, GivesItsPosesOfTheLastSeconds)
{
  VehicleModel model = modelOn(Material::asphalt, {});
  model.step({1, 0.2}, 1.234);
  EXPECT_DOUBLE_EQ(model.state().t_s, 1.23);
  model.step({1, 0.2}, 0.006);
  EXPECT_DOUBLE_EQ(model.state().t_s, 1.24);
  const Motion recent = model.recent(0.5);
  EXPECT_DOUBLE_EQ(recent.poses().front().t_s, 0.74);
  EXPECT_DOUBLE_EQ(recent.poses().back().t_s, 1.24);
  EXPECT_EQ(recent.poses().size(), 51U);
  EXPECT_EQ(model.recent(100).poses().size(), 125U);
  model.step({1, 0.2}, 60);
  EXPECT_EQ(model.recent(100).poses().size(), 2001U);  // kKept_s
}

TEST(VehicleModel, IsTheSameInStepsOfAnySize)
{
  VehicleModel once = modelOn(Material::ice, carLike());
  VehicleModel often = modelOn(Material::ice, carLike());
  once.step({1, 0.7}, 2);
  for (int i = 0; i < 40; ++i)
  {
    often.step({1, 0.7}, 0.05);
  }
  EXPECT_EQ(once.state().t_s, often.state().t_s);
  EXPECT_EQ(once.T_map_base().matrix(), often.T_map_base().matrix());
  EXPECT_EQ(once.state().aside_mps, often.state().aside_mps);
}

TEST(VehicleModel, RefusesWhatIsNoNumber)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  VehicleModel model = modelOn(Material::asphalt, {});
  EXPECT_THROW(model.step({nan, 0}, 0.1), std::invalid_argument);
  EXPECT_THROW(model.step({0, nan}, 0.1), std::invalid_argument);
  EXPECT_THROW(model.step({0, 0}, nan), std::invalid_argument);
  EXPECT_THROW(model.step({0, 0}, 0), std::invalid_argument);
  EXPECT_THROW(modelOn(Material::asphalt, {}, {nan, 0, 0}), std::invalid_argument);
  EXPECT_THROW(VehicleModel(nullptr, {}, {}, {}), std::invalid_argument);
}

TEST(Friction, GrowsFromIceToTarmac)
{
  EXPECT_LT(frictionOf(Material::ice), frictionOf(Material::snow));
  EXPECT_LT(frictionOf(Material::snow), frictionOf(Material::soil));
  EXPECT_LT(frictionOf(Material::soil), frictionOf(Material::asphalt));
  for (size_t i = 0; i < kMaterials; ++i)
  {
    EXPECT_GT(frictionOf(static_cast<Material>(i)), 0);
  }
}
}  // namespace
