// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/drivetrain.h>
#include <traverse/navigation/planner.h>

#include <gtest/gtest.h>

#include <cmath>
#include <support/outline_check.h>

namespace traverse::testing
{
/** A small car: 1.0 m long, 0.6 m wide, its circle 1.2 m. */
struct Car
{
  geometry::Vehicle vehicle;
  geometry::Drivetrain drivetrain;

  Car()
  {
    vehicle.footprint_xs_m = {-0.2, 0.8, 0.8, -0.2};
    vehicle.footprint_ys_m = {-0.3, -0.3, 0.3, 0.3};
    drivetrain.steering = geometry::Steering::ackermann;
    drivetrain.wheelbase_m = 0.6928;
    drivetrain.max_steer_deg = 30;
  }

  navigation::Planner planner() const { return {vehicle, drivetrain, {}}; }
};

/** How a path is driven. */
struct Driven
{
  double forward_m = 0;
  double backward_m = 0;
  int turns = 0;  // between forward and backward
};

/** Expects that a car can drive a path, point by point, and touches nothing. */
inline Driven expectDriveable(
    const navigation::Path& path, const navigation::Costmap& map, const Car& car)
{
  Driven driven;
  const double most_1pm = 1 / geometry::minTurningRadius_m(car.drivetrain);
  for (size_t k = 0; k < path.size(); ++k)
  {
    const navigation::PathPoint& a = path[k];
    EXPECT_FALSE(touchesObstacle(map, car.vehicle, a.pose, 1e-9)) << k;
    if (k + 1 == path.size())
    {
      break;
    }
    const navigation::PathPoint& b = path[k + 1];
    const double step_m = b.along_m - a.along_m;
    EXPECT_GT(step_m, 0) << k;
    EXPECT_LE(step_m, 0.1 + 1e-9) << k;
    EXPECT_LE(std::abs(a.curvature_1pm), most_1pm) << k;
    // By the middle of the arc: what it turns is curvature times way, and it moves along the
    // heading between. 1e-4 m: an arc of 0.1 m of the tightest circle is 3e-5 m longer than its
    // chord.
    const double signed_m = a.is_backward ? -step_m : step_m;
    const double turn = std::remainder(b.pose.yaw_rad - a.pose.yaw_rad, 2 * M_PI);
    EXPECT_NEAR(turn, a.curvature_1pm * signed_m, 1e-9) << k;
    const double middle = a.pose.yaw_rad + turn / 2;
    EXPECT_NEAR(b.pose.x_m - a.pose.x_m, signed_m * std::cos(middle), 1e-4) << k;
    EXPECT_NEAR(b.pose.y_m - a.pose.y_m, signed_m * std::sin(middle), 1e-4) << k;
    (a.is_backward ? driven.backward_m : driven.forward_m) += step_m;
    driven.turns += k > 0 && a.is_backward != path[k - 1].is_backward ? 1 : 0;
  }
  return driven;
}
}  // namespace traverse::testing
