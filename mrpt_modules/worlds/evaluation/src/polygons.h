// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/evaluation/outlines.h>

#include <limits>
#include <vector>

namespace traverse::evaluation
{
struct Box
{
  Eigen::Vector2d min = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d max = Eigen::Vector2d::Constant(-std::numeric_limits<double>::infinity());

  /** A lower bound of the distance to what is within. */
  double distanceTo(const Eigen::Vector2d& p) const
  {
    return (min - p).cwiseMax(p - max).cwiseMax(0.0).norm();
  }
};

Box boxOf(const TrueOutline& outline);

/** From the nearest of the polygons; 0 within one. */
double distanceToAny(const TrueOutline& outline, const Eigen::Vector2d& place);

/** Sum over the polygons. */
double areaOf(const TrueOutline& outline);

/** Places along the polygons' edges, at most a step apart (or 10000 an edge). */
std::vector<Eigen::Vector2d> edgePlaces(const TrueOutline& outline, double step_m);
}  // namespace traverse::evaluation
