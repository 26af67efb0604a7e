// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cmath>

namespace traverse::points
{
/** Rounded to a multiple of 2^-40: sin and cos of different C libraries and processors differ in
 * their last bits, and maps are promised to be the same bytes on all of them. */
inline double onGrid(double v)
{
  constexpr double kGrid = 1099511627776.0;
  return std::nearbyint(v * kGrid) / kGrid;
}

/** Unit vector in the sensor frame. */
inline Eigen::Vector3d beamDirection(double azimuth_rad, double elevation_rad)
{
  const double c = std::cos(elevation_rad);
  return {
      onGrid(c * std::cos(azimuth_rad)), onGrid(c * std::sin(azimuth_rad)),
      onGrid(std::sin(elevation_rad))};
}
}  // namespace traverse::points
