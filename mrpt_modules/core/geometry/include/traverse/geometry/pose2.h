// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace traverse::geometry
{
/** Where a vehicle's frame is on the map, seen from above. */
struct Pose2
{
  double x_m = 0;
  double y_m = 0;
  double yaw_rad = 0;  //!< of its x axis from the map's, counter-clockwise
};

/** What a vehicle is told to do, or does: along its x axis, and turning. */
struct Twist2
{
  double speed_mps = 0;
  double yaw_rate_radps = 0;  //!< counter-clockwise
};
}  // namespace traverse::geometry
