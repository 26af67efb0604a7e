// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace traverse::geometry
{
/** Where a vehicle's frame is on the map, seen from above. */
struct Pose2
{
  double x_m = 0;
  double y_m = 0;
  double yaw_rad = 0;  //!< of its x axis from the map's, counter-clockwise
};

/** Between their places, m. */
inline double distance_m(const Pose2& a, const Pose2& b)
{
  const double dx = a.x_m - b.x_m;
  const double dy = a.y_m - b.y_m;
  return std::sqrt(dx * dx + dy * dy);
}

/** What a vehicle is told to do, or does: along its x axis, and turning. */
struct Twist2
{
  double speed_mps = 0;
  double yaw_rate_radps = 0;  //!< counter-clockwise
};
}  // namespace traverse::geometry
