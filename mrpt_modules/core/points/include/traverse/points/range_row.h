// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/points/decoded.h>

#include <span>
#include <string>

namespace traverse::points
{
/** One row of a scanner: beams of one elevation (0: in the sensor's x-y plane) at equal steps of
 * bearing. */
struct RangeRow
{
  TimeNs stamp = 0;
  std::string sensor_label;
  Eigen::Isometry3d T_base_sensor = Eigen::Isometry3d::Identity();
  std::span<const float> range_m;  //!< anything may stand here
  std::span<const char> valid;     //!< 0: the sensor got no echo, or says so; may be empty
  double first_bearing_rad = 0;    //!< of range_m[0]; 0 is forward, counter-clockwise
  double step_rad = 0;             //!< negative for a clockwise scanner
  double elevation_rad = 0;        //!< of the whole row (one laser of a spinning scanner)
  float sensor_max_range_m = 0;    //!< from here on it is "no return"
  RangeLimits limits;
};

/** Points and a one-row range image, columns by growing bearing.
 *
 * No return: flagged without echo (range 0 or at least the longest), or a range from the longest
 * on. Rejected: NaN, Inf, negative, too near, or flagged bad at a range within reach. A range
 * beyond the ini's limit but within the sensor's counts as beyond_range; the beam did meet nothing
 * within the limit, and the image shows that. Throws std::invalid_argument where `valid` has
 * another length, or an angle is not finite. */
Decoded decodeRow(const RangeRow& row);
}  // namespace traverse::points
