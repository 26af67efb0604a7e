// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/outline.h>

namespace traverse::geometry
{
/** Distance between two convex outlines (counter-clockwise, three corners or more), m; negative:
 * the shortest move that parts them. */
double apart(const Outline& a, const Outline& b);

/** Distance of a place from a convex outline, m; negative inside. */
double apart(const Eigen::Vector2d& place, const Outline& outline);

/** A disc that holds an outline. */
struct Round
{
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  double radius_m = 0;
};

Round roundOf(const Outline& outline);
}  // namespace traverse::geometry
