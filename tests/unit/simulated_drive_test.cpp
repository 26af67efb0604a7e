// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/simple_scene.h"

#include <traverse/simulation/drive.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace traverse::testing
{
namespace
{
using simulation::driveOn;
using simulation::DriveParams;
using simulation::Motion;

geometry::Vehicle car()
{
  geometry::Vehicle vehicle;
  vehicle.footprint_xs_m = {-1.2, 2.8, 2.8, -1.2};
  vehicle.footprint_ys_m = {-0.9, -0.9, 0.9, 0.9};
  vehicle.base_height_m = 0.4;
  return vehicle;
}

/** A circle's points, 20 m radius, and the speed 10 m/s from the first moment. */
DriveParams bend()
{
  DriveParams params;
  params.xs_m.clear();
  params.ys_m.clear();
  for (int i = 0; i <= 8; ++i)
  {
    const double angle_rad = i * std::numbers::pi / 16;
    params.xs_m.push_back(20 * std::sin(angle_rad));
    params.ys_m.push_back(20 - 20 * std::cos(angle_rad));
  }
  params.speed_mps = 10;
  params.accel_mps2 = 0;
  return params;
}

TEST(Drive, GoesThroughItsPoints)
{
  const DriveParams params = bend();
  const Motion drive = driveOn(PlaneTerrain(), params, car());
  for (size_t i = 0; i < params.xs_m.size(); ++i)
  {
    double nearest_m = 1e9;
    for (const auto& pose : drive.poses())
    {
      const auto p = pose.T_map_body.translation();
      nearest_m = std::min(nearest_m, std::hypot(p.x() - params.xs_m[i], p.y() - params.ys_m[i]));
    }
    EXPECT_LT(nearest_m, 0.06);  // poses are 0.1 m apart
  }
}

TEST(Drive, KeepsItsSpeedAndTurnsSmoothly)
{
  const Motion drive = driveOn(PlaneTerrain(), bend(), car());
  const auto& poses = drive.poses();
  double last_turn_rad = 0;
  for (size_t i = 1; i + 2 < poses.size(); ++i)
  {
    const Eigen::Isometry3d step = poses[i - 1].T_map_body.inverse() * poses[i].T_map_body;
    EXPECT_NEAR(step.translation().norm(), 0.1, 2e-4) << i;
    EXPECT_NEAR(step.translation().y(), 0, 1e-3) << i;  // forward, not sideways
    const double turn_rad = std::atan2(step.linear()(1, 0), step.linear()(0, 0));
    // the curvature of 1/20 m grows from 0 within the first chord of 4 m: 0.1 m * 0.1 m / (80 m2)
    EXPECT_NEAR(turn_rad, last_turn_rad, 4e-4) << i;
    last_turn_rad = turn_rad;
  }
}

TEST(Drive, StandsOnTheSlopeThatItIsOn)
{
  const PlaneTerrain slope(1, 0.1, 0.2);
  DriveParams params;
  params.xs_m = {0, 10};
  params.ys_m = {0, 0};
  const Motion drive = driveOn(slope, params, car());
  const Eigen::Vector3d up = Eigen::Vector3d(-0.1, -0.2, 1).normalized();
  for (const auto& pose : drive.poses())
  {
    EXPECT_LT((pose.T_map_body.linear().col(2) - up).norm(), 1e-9);
    const Eigen::Vector3d wheels = pose.T_map_body * Eigen::Vector3d(0, 0, -0.4);
    EXPECT_NEAR(wheels.z(), slope.at(wheels.x(), wheels.y()).height_m, 1e-9);
    EXPECT_NEAR(pose.T_map_body.linear().determinant(), 1, 1e-12);
  }
}

TEST(Drive, DrivesOffAndStopsAsFastAsItIsTold)
{
  DriveParams params;
  params.xs_m = {0, 100};
  params.ys_m = {0, 0};
  params.speed_mps = 10;
  params.accel_mps2 = 2;
  params.start_s = 1;
  const Motion drive = driveOn(PlaneTerrain(), params, car());
  EXPECT_NEAR(drive.poses().back().t_s, 1 + 5 + 7.5 + 2.5 - 0, 0.011);  // 25 m + 50 m + 25 m
  const auto x = [&](double t_s) { return drive.at(t_s).translation().x(); };
  EXPECT_NEAR(x(1), 0, 1e-9);
  EXPECT_NEAR(x(3), 4, 1e-3);
  EXPECT_NEAR(x(6), 25, 1e-3);
  EXPECT_NEAR(x(11), 75, 1e-3);
  EXPECT_NEAR(x(16), 100, 1e-3);
}

TEST(Drive, TakesTheTimeThatItIsGiven)
{
  DriveParams params;
  params.xs_m = {3};
  params.ys_m = {4};
  params.duration_s = 2.5;
  const Motion drive = driveOn(PlaneTerrain(), params, car());
  EXPECT_DOUBLE_EQ(drive.poses().back().t_s, 2.5);
  EXPECT_EQ(drive.poses().front().T_map_body.matrix(), drive.poses().back().T_map_body.matrix());
}

TEST(Drive, RefusesWhatIsNoLine)
{
  const auto refused = [](std::vector<double> xs_m, std::vector<double> ys_m)
  {
    DriveParams params;
    params.xs_m = std::move(xs_m);
    params.ys_m = std::move(ys_m);
    EXPECT_THROW(driveOn(PlaneTerrain(), params, car()), std::invalid_argument);
  };
  refused({}, {});
  refused({1, 2}, {1});
  refused({1, 1}, {2, 2});
  refused({0, 1e5, -1e5}, {0, 0, 1});
  refused({1}, {1});  // takes no time
}
}  // namespace
}  // namespace traverse::testing
