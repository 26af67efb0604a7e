// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "outline.h"

#include <traverse/navigation/grip.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace traverse::navigation
{
Grip gripOn(double friction, const geometry::Drivetrain& drivetrain, const SpeedParams& params)
{
  const double coefficient = std::isnan(friction) ? params.friction : friction;
  const double sum = params.friction_margin * coefficient * kGravity;
  return {std::min(drivetrain.max_decel_mps2, sum), std::min(params.lateral_accel_mps2, sum), sum};
}

Grip weaker(const Grip& a, const Grip& b)
{
  return {
      std::min(a.brake_mps2, b.brake_mps2), std::min(a.lateral_mps2, b.lateral_mps2),
      std::min(a.sum_mps2, b.sum_mps2)};
}

double frictionUnder(
    const Costmap& costmap, const geometry::Vehicle& vehicle, const geometry::Pose2& pose)
{
  double least = std::numeric_limits<double>::quiet_NaN();
  if (costmap.friction.empty())
  {
    return least;
  }
  if (std::abs(pose.x_m) <= geometry::kFarthest_m && std::abs(pose.y_m) <= geometry::kFarthest_m)
  {
    least = costmap.frictionAt(costmap.cellAt(pose.x_m, pose.y_m));
  }
  Outline(vehicle, pose)
      .forEachMiddle(
          costmap.lattice, costmap.extent,
          [&](geometry::CellIndex c)
          { least = std::fmin(least, costmap.frictionAt(c)); });  // NaN where both are
  return least;
}
}  // namespace traverse::navigation
