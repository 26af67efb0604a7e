// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/simulation/scene.h>

#include <Eigen/Core>

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace traverse::simulation
{
/** A straight piece of a line. */
struct Segment
{
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  Eigen::Vector2d unit = Eigen::Vector2d::UnitX();
  double length_m = 0;
  double begins_m = 0;  //!< along the whole line
};

/** Where a place lies along and beside a line. */
struct AlongLine
{
  double along_m = 0;
  double left_m = 0;                                           //!< positive to the left of the line
  double square_m2 = std::numeric_limits<double>::infinity();  //!< of the distance to it
};

/** The line through the corners. Throws OptionError naming `keys` where there are fewer than two,
 * other numbers of x and y, or the same corner twice running. */
std::vector<Segment> lineThrough(
    const std::vector<double>& xs_m, const std::vector<double>& ys_m, const std::string& keys);

/** Of the nearest of the segments; beyond the ends along_m is < 0 or > the line's length. */
AlongLine alongLine(std::span<const Segment> segments, double line_m, const Eigen::Vector2d& place);

/** True where the segment may be nearer than reach_m to a place of the area (never false where it
 * is). */
bool mayReach(const Segment& segment, double reach_m, const Area& area);

/** Length of the whole line. */
double lengthOf(const std::vector<Segment>& line);

/** The place that far along it; before and behind it on its first and last piece's line. */
Eigen::Vector2d placeAlong(const std::vector<Segment>& line, double along_m);

/** The piece on which a place that far along it lies. */
const Segment& segmentAt(const std::vector<Segment>& line, double along_m);
}  // namespace traverse::simulation
