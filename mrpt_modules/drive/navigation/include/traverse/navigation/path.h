// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/pose2.h>

#include <vector>

namespace traverse::navigation
{
/** A place of a path. */
struct PathPoint
{
  geometry::Pose2 pose;      //!< yaw: where the vehicle looks, also when it drives backward
  double along_m = 0;        //!< way from the path's beginning
  double curvature_1pm = 0;  //!< of the way from here on, left turns positive
  bool is_backward = false;  //!< from here to the next point
};

/** A way, a point every 5 to 30 cm. */
using Path = std::vector<PathPoint>;
}  // namespace traverse::navigation
