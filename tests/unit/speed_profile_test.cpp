// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/geometry/exact_trig.h>
#include <traverse/navigation/speed_profile.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <support/cost_pictures.h>

namespace
{
using namespace traverse;
using namespace traverse::navigation;
using namespace traverse::testing;

constexpr double kAnySpeed = 100;  // so fast at the beginning that it limits nothing

/** Differences of rounding only. */
constexpr double kRounding = 1e-9;

/** Friction and curves limit nothing, and neither do creeping and hard buffers. */
SpeedParams plain()
{
  SpeedParams params;
  params.friction = 2;
  params.friction_margin = 1;
  params.lateral_accel_mps2 = 20;
  params.reaction_s = 0;
  params.creep_mps = 0.01;
  return params;
}

geometry::Drivetrain drivetrain(double speed_mps, double accel_mps2, double decel_mps2)
{
  geometry::Drivetrain drivetrain;
  drivetrain.max_speed_mps = speed_mps;
  drivetrain.max_accel_mps2 = accel_mps2;
  drivetrain.max_decel_mps2 = decel_mps2;
  drivetrain.max_yaw_rate_degps = 720;
  return drivetrain;
}

/** Along x from 0.05 m on, a point every 10 cm, in the lowest row of cells. */
Path straight(double length_m)
{
  Path path;
  const auto points = static_cast<int>(std::round(length_m * 10)) + 1;
  for (int i = 0; i < points; ++i)
  {
    path.push_back({{0.05 + 0.1 * i, 0.05, 0}, 0.1 * i, 0, false});
  }
  return path;
}

/** One row of cells of 0.1 m, as drawn. */
Costmap row(const std::string& cells)
{
  return costsOf({occupancyOf({cells, cells, cells}, 100)}, withoutBuffers());
}

Costmap open(size_t cells)
{
  return row(std::string(cells, '.'));
}

TEST(SpeedProfile, IsATrapezeOfAccelerationSpeedAndBraking)
{
  const Path path = straight(20);
  const auto limits = speedProfile(path, open(210), drivetrain(3, 1, 2), 0, plain());
  for (size_t i = 0; i < path.size(); ++i)
  {
    const double s = path[i].along_m;
    const double creep = 0.01;
    const double expected = std::min(
        {3.0, std::sqrt(creep * creep + 2 * 1 * s), std::sqrt(2 * 2 * std::max(0.0, 20 - s))});
    ASSERT_NEAR(limits[i].speed_mps, expected, 1e-6) << "at " << s;  // sums of 200 roots' squares
  }
  EXPECT_EQ(limits.front().reason, SpeedReason::vehicle);
  EXPECT_EQ(limits[100].reason, SpeedReason::vehicle);
  EXPECT_EQ(limits.back().reason, SpeedReason::end);
  EXPECT_EQ(limits[limits.size() - 5].reason, SpeedReason::end);
  EXPECT_EQ(limits.back().speed_mps, 0);
}

TEST(SpeedProfile, GoesOnFromTheSpeedThatItHas)
{
  const auto limits = speedProfile(straight(20), open(210), drivetrain(3, 1, 2), 2, plain());
  EXPECT_NEAR(limits[0].speed_mps, 2, kRounding);
  EXPECT_NEAR(limits[10].speed_mps, std::sqrt(2.0 * 2 + 2 * 1 * 1.0), kRounding);
}

TEST(SpeedProfile, SlowsDownForCurvesByLateralAcceleration)
{
  Path path = straight(20);
  for (size_t i = 100; i < 120; ++i)
  {
    path[i].curvature_1pm = i % 2 == 0 ? 0.5 : -0.5;
  }
  SpeedParams params = plain();
  params.lateral_accel_mps2 = 1;
  const auto limits = speedProfile(path, open(210), drivetrain(3, 1, 2), kAnySpeed, params);
  EXPECT_NEAR(limits[110].speed_mps, std::sqrt(2.0), kRounding);
  EXPECT_EQ(limits[110].reason, SpeedReason::curve);
  EXPECT_NEAR(limits[120].speed_mps, std::sqrt(2.0), kRounding);  // the curve's end
  // Braking straight on before it, accelerating straight on behind it.
  EXPECT_NEAR(limits[95].speed_mps, std::sqrt(2.0 + 2 * 2 * 0.5), kRounding);
  EXPECT_EQ(limits[95].reason, SpeedReason::curve);
  EXPECT_NEAR(limits[125].speed_mps, std::sqrt(2.0 + 2 * 1 * 0.5), kRounding);
  EXPECT_EQ(limits[125].reason, SpeedReason::vehicle);
}

TEST(SpeedProfile, TakesNoMoreThanItsShareOfTheFriction)
{
  Path path = straight(20);
  for (size_t i = 60; i < 120; ++i)
  {
    path[i].curvature_1pm = 0.2;
  }
  SpeedParams params = plain();
  params.friction = 0.3;
  params.friction_margin = 0.5;
  const double most = 0.3 * 0.5 * 9.81;
  const auto limits = speedProfile(path, open(210), drivetrain(6, 3, 3), 0, params);
  EXPECT_NEAR(limits[90].speed_mps, std::sqrt(most / 0.2), kRounding);
  for (size_t i = 0; i + 1 < path.size(); ++i)
  {
    const double a = limits[i].speed_mps * limits[i].speed_mps;
    const double b = limits[i + 1].speed_mps * limits[i + 1].speed_mps;
    const double along = (b - a) / (2 * 0.1);
    const double across = std::abs(path[i].curvature_1pm) * std::max(a, b);
    ASSERT_LE(std::sqrt(along * along + across * across), most + 1e-6) << "at " << i;
  }
  // In the curve it could not have braked before the end as hard as straight on.
  EXPECT_NEAR(limits[190].speed_mps, std::sqrt(2 * most * 1.0), 1e-6);
}

TEST(SpeedProfile, TurnsNoFasterThanADifferentialVehicleDoes)
{
  Path path = straight(5);
  for (PathPoint& point : path)
  {
    point.curvature_1pm = 2;
  }
  geometry::Drivetrain vehicle = drivetrain(3, 1, 2);
  vehicle.max_yaw_rate_degps = 90;
  const auto turned = speedProfile(path, open(60), vehicle, kAnySpeed, plain());
  EXPECT_NEAR(turned[10].speed_mps, geometry::kPi / 2 / 2, kRounding);
  EXPECT_EQ(turned[10].reason, SpeedReason::curve);
  vehicle.steering = geometry::Steering::ackermann;
  const auto steered = speedProfile(path, open(60), vehicle, kAnySpeed, plain());
  EXPECT_GT(steered[10].speed_mps, 2);
}

TEST(SpeedProfile, HeedsTheGround)
{
  layers::LayerSet map =
      classesOf({std::string(50, '1') + std::string(10, '3') + std::string(150, '1')}, 100);
  const Costmap costmap = costsOf({map}, withoutBuffers());
  const auto limits = speedProfile(straight(20), costmap, drivetrain(3, 1, 2), kAnySpeed, plain());
  EXPECT_EQ(limits[55].speed_mps, 0.5);
  EXPECT_EQ(limits[55].reason, SpeedReason::ground);
  EXPECT_NEAR(limits[45].speed_mps, std::sqrt(0.25 + 2 * 2 * 0.5), kRounding);
  EXPECT_EQ(limits[45].reason, SpeedReason::ground);
}

TEST(SpeedProfile, StopsBeforeTheUnknown)
{
  SpeedParams params = plain();
  params.reaction_s = 0.5;
  params.creep_mps = 0.2;
  const Costmap costmap = row(std::string(100, '.') + std::string(50, ' ') + std::string(60, '.'));
  const auto limits = speedProfile(straight(20), costmap, drivetrain(3, 1, 2), kAnySpeed, params);
  for (const size_t i : {20U, 80U, 90U, 95U})
  {
    const double v = limits[i].speed_mps;
    const double way_m = 0.1 * (100 - static_cast<double>(i));
    // v reaction + v^2 / (2 deceleration) is the way that is left, or it drives as fast as it can.
    EXPECT_TRUE(std::abs(v * 0.5 + v * v / 4 - way_m) < kRounding || v == 3) << "at " << i;
  }
  EXPECT_LT(limits[80].speed_mps, 3);
  EXPECT_EQ(limits[80].reason, SpeedReason::unknown);
  EXPECT_EQ(limits[100].speed_mps, 0.2);
  EXPECT_EQ(limits[125].speed_mps, 0.2);
  EXPECT_EQ(limits[125].reason, SpeedReason::unknown);
  // It accelerates from the last unknown point on, 1.1 m before.
  EXPECT_NEAR(limits[160].speed_mps, std::sqrt(0.2 * 0.2 + 2 * 1 * 1.1), kRounding);
}

TEST(SpeedProfile, TakesWhatLiesOutsideForUnknown)
{
  const auto limits =
      speedProfile(straight(20), open(100), drivetrain(3, 1, 2), kAnySpeed, plain());
  EXPECT_EQ(limits[150].reason, SpeedReason::unknown);
  EXPECT_EQ(limits[150].speed_mps, 0.01);
}

TEST(SpeedProfile, TakesAGapBetweenBeamsForNoUnknown)
{
  std::string gap(210, '.');
  gap[60] = ' ';
  const std::string whole(210, '.');
  const Path path = straight(20);
  const Costmap with_gap = costsOf({occupancyOf({whole, gap, whole}, 100)}, withoutBuffers());
  Path through = path;
  for (PathPoint& point : through)
  {
    point.pose.y_m = 0.15;
  }
  const auto limits = speedProfile(through, with_gap, drivetrain(3, 1, 2), kAnySpeed, plain());
  EXPECT_EQ(limits[60].speed_mps, 3);
}

TEST(SpeedProfile, SlowsDownBesideHardBuffers)
{
  SpeedParams params = plain();
  params.reaction_s = 0.3;
  const std::string free(210, '.');
  std::string wall = free;
  std::fill(wall.begin() + 100, wall.begin() + 140, '#');
  // The wall's cells are 0.3 m from the path.
  const Costmap costmap =
      costsOf({occupancyOf({free, wall, free, free, free}, 100)}, withoutBuffers());
  const auto limits = speedProfile(straight(20), costmap, drivetrain(3, 1, 2), kAnySpeed, params);
  EXPECT_NEAR(limits[120].speed_mps, 0.3 / 0.3, kRounding);
  EXPECT_EQ(limits[120].reason, SpeedReason::clearance);
  EXPECT_EQ(limits[20].speed_mps, 3);
  params.reaction_s = 0;
  EXPECT_EQ(
      speedProfile(straight(20), costmap, drivetrain(3, 1, 2), kAnySpeed, params)[120].speed_mps,
      3);
}

TEST(SpeedProfile, StopsWhereItTurnsRound)
{
  Path path = straight(20);
  for (size_t i = 100; i < path.size(); ++i)
  {
    path[i].is_backward = true;
  }
  geometry::Drivetrain vehicle = drivetrain(3, 1, 2);
  vehicle.max_reverse_mps = 0.5;
  const auto limits = speedProfile(path, open(210), vehicle, kAnySpeed, plain());
  EXPECT_EQ(limits[100].speed_mps, 0);
  EXPECT_EQ(limits[100].reason, SpeedReason::end);
  EXPECT_NEAR(limits[95].speed_mps, std::sqrt(2 * 2 * 0.5), kRounding);
  EXPECT_EQ(limits[150].speed_mps, 0.5);
}

TEST(SpeedProfile, CreepsRatherThanStandsWhereNothingStopsIt)
{
  SpeedParams params = plain();
  params.creep_mps = 0.15;
  Path path = straight(5);
  path[20].curvature_1pm = 1e9;
  const auto limits = speedProfile(path, open(60), drivetrain(3, 1, 2), 0, params);
  EXPECT_EQ(limits[0].speed_mps, 0.15);
  EXPECT_EQ(limits[20].speed_mps, 0.15);
  EXPECT_EQ(limits.back().speed_mps, 0);
  // But never faster than the vehicle drives.
  EXPECT_EQ(speedProfile(path, open(60), drivetrain(0.05, 1, 2), 0, params)[20].speed_mps, 0.05);
}

TEST(SpeedProfile, BearsPathsThatAreNone)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(speedProfile({}, open(3), {}, 0, {}).empty());
  const Path one = {{{0.05, 0.05, 0}, 0, 0, false}};
  EXPECT_EQ(speedProfile(one, open(3), {}, 1, {})[0].speed_mps, 0);
  const Path bad = {
      {{nan, 0, nan}, nan, nan, false}, {{1e300, 0, 0}, -5, nan, false}, {{0, 0, 0}, 1, 0, false}};
  for (const SpeedLimit& limit : speedProfile(bad, open(3), {}, nan, {}))
  {
    EXPECT_TRUE(limit.speed_mps >= 0 && limit.speed_mps <= 1) << limit.speed_mps;
  }
}
}  // namespace
