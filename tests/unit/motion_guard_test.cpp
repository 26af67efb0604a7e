// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/navigation/motion_guard.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{
using namespace traverse;
using navigation::MotionGuard;

/** 1 x 0.6 m, brakes with 2 m/s2. */
MotionGuard guard()
{
  geometry::Vehicle vehicle;
  vehicle.footprint_xs_m = {-0.5, 0.5, 0.5, -0.5};
  vehicle.footprint_ys_m = {-0.3, -0.3, 0.3, 0.3};
  geometry::Drivetrain drivetrain;
  drivetrain.max_decel_mps2 = 2;
  return {vehicle, drivetrain, {0.1, 0.1}};
}

using Points = std::vector<Eigen::Vector3f>;

TEST(MotionGuard, WhatIsFarOrAsideDoesNotHinder)
{
  const Points points = {{3, 0, 0}, {1, 0.45F, 0}, {-0.7F, 0, 0}};
  const geometry::Twist2 passed = guard().guarded({1, 0}, {1, 0}, points);
  EXPECT_EQ(passed.speed_mps, 1);
}

TEST(MotionGuard, SlowsDownToWhatStillStopsBeforeAnObstacle)
{
  // the front (0.5 m) and its margin (0.1 m) are 0.2 m from the point; steps of 5 cm round down
  const Points points = {{0.8F, 0, 0}};
  const geometry::Twist2 slowed = guard().guarded({1, 0.5}, {1, 0.5}, points);
  const double stops_m = slowed.speed_mps * 0.1 + slowed.speed_mps * slowed.speed_mps / 4;
  EXPECT_LE(stops_m, 0.2 + 1e-9);
  EXPECT_GE(stops_m, 0.1);
  EXPECT_NEAR(slowed.yaw_rate_radps / slowed.speed_mps, 0.5, 1e-12);  // the same arc
}

TEST(MotionGuard, StandsBeforeATouchAndMayBackOff)
{
  const Points points = {{0.61F, 0, 0}};
  EXPECT_NEAR(guard().guarded({1, 0}, {0, 0}, points).speed_mps, 0, 1e-9);
  EXPECT_EQ(guard().guarded({-0.5, 0}, {0, 0}, points).speed_mps, -0.5);
}

TEST(MotionGuard, WithinTheMarginOnlyComingNearerIsHindered)
{
  const Points beside = {{0, 0.35F, 0}};
  EXPECT_EQ(guard().guarded({1, 0}, {0, 0}, beside).speed_mps, 1);
  const Points ahead = {{0.55F, 0, 0}};
  EXPECT_NEAR(guard().guarded({1, 0}, {0, 0}, ahead).speed_mps, 0, 1e-9);
}

TEST(MotionGuard, TheArcItStillDrivesCountsToo)
{
  // told to go straight on, still in a left curve of 1 m towards a point
  const Points points = {{0.72F, 0.42F, 0}};
  EXPECT_EQ(guard().guarded({0.8, 0}, {0.8, 0}, points).speed_mps, 0.8);
  EXPECT_LT(guard().guarded({0.8, 0}, {0.8, 0.8}, points).speed_mps, 0.8);
}

TEST(MotionGuard, CornersThatComeRoundStopATurnOnTheSpot)
{
  const Points points = {{0.4F, 0.33F, 0}};
  EXPECT_EQ(guard().guarded({0, 0.5}, {0, 0}, points).yaw_rate_radps, 0);
  EXPECT_EQ(guard().guarded({0, -0.5}, {0, 0}, points).yaw_rate_radps, -0.5);
}
}  // namespace
