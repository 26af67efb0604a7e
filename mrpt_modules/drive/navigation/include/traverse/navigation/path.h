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
  double curvature_1pm = 0;  //!< from here on; wheels to the left positive, also backward
  bool is_backward = false;  //!< from here to the next point
};

/** A way, a point every 10 cm or less. */
using Path = std::vector<PathPoint>;
}  // namespace traverse::navigation
