// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/navigation/cell_walk.h>
#include <traverse/navigation/path.h>

#include <cstddef>
#include <limits>
#include <span>

namespace traverse::navigation
{
/** Where on a path a place is nearest to. */
struct OnPath
{
  size_t next = 0;     //!< point that comes next there, or the last one
  Place nearest;       //!< of the path
  double along_m = 0;  //!< by PathPoint::along_m
  double off_m = std::numeric_limits<double>::infinity();  //!< from there to the place
};

/** The nearest place of the lines through the points; off_m is infinite where there are none. */
OnPath nearestOn(std::span<const PathPoint> path, Place place);
}  // namespace traverse::navigation
