// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/exact_trig.h>

#include <Eigen/Core>

namespace traverse::points
{
/** Unit vector in the sensor frame, with the same bits on every processor; NaN for angles that are
 * none. */
inline Eigen::Vector3d beamDirection(double azimuth_rad, double elevation_rad)
{
  const geometry::SinCos azimuth = geometry::sinCosOfAny(azimuth_rad);
  const geometry::SinCos elevation = geometry::sinCosOfAny(elevation_rad);
  return {elevation.cos * azimuth.cos, elevation.cos * azimuth.sin, elevation.sin};
}
}  // namespace traverse::points
