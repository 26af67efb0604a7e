// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/points/scan.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <string>
#include <vector>

namespace traverse::points
{
/** What a beam of a range image met. */
enum class Beam : uint8_t
{
  no_return = 0,  //!< nothing within range: it may clear, and it may be a ditch
  hit = 1,
  rejected = 2,  //!< NaN, Inf, flagged bad, never fired: it means nothing
};

/** One observation as rows by elevation (row 0 lowest) and columns by azimuth (growing, counter-
 * clockwise seen from above), from one sensor origin. All arrays are row-major, rows x columns.
 *
 * range_m is NaN unless beam is hit. x, y, z (vehicle frame) come from range and the beam's own
 * direction: direction(row, column) in the *sensor* frame has elevation_rad[i] and azimuth_rad[i],
 * per beam, because a real row is not a line of one elevation nor a column one of azimuth. */
struct RangeImage
{
  TimeNs stamp = 0;
  std::string sensor_label;
  Eigen::Isometry3d T_base_sensor = Eigen::Isometry3d::Identity();
  int rows = 0;
  int columns = 0;
  bool closes = false;  //!< the last column is the first one's neighbour (a full turn)
  float max_range_m = 0;
  std::vector<Beam> beam;
  std::vector<float> range_m;
  std::vector<float> azimuth_rad;    //!< sensor frame, atan2(y, x)
  std::vector<float> elevation_rad;  //!< sensor frame, asin(z / r)
  std::vector<float> time_s;         //!< relative to stamp; may be empty

  size_t index(int row, int column) const { return static_cast<size_t>(row) * columns + column; }

  size_t size() const { return beam.size(); }
};
}  // namespace traverse::points
