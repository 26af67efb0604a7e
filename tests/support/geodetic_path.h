// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/geodesy.h>

#include <Eigen/Core>

#include <cmath>

namespace traverse::testing
{
/** The place that lies at `enu_m` of the tangent plane at `origin`, by turning into Earth-centred
 * coordinates with libm and Bowring's iteration back: independent of LocalPlane. */
inline geometry::Geodetic placeAt(const geometry::Geodetic& origin, const Eigen::Vector3d& enu_m)
{
  constexpr double kA = 6378137.0;
  constexpr double kB = 6356752.314245179;
  constexpr double kE2 = 1 - kB * kB / (kA * kA);
  constexpr double kRad = M_PI / 180;
  const double lat = origin.latitude_deg * kRad;
  const double lon = origin.longitude_deg * kRad;
  const double n = kA * kA / std::hypot(kA * std::cos(lat), kB * std::sin(lat));
  const Eigen::Vector3d up(
      std::cos(lat) * std::cos(lon), std::cos(lat) * std::sin(lon), std::sin(lat));
  const Eigen::Vector3d east(-std::sin(lon), std::cos(lon), 0);
  const Eigen::Vector3d north = up.cross(east);
  Eigen::Vector3d p(n * up.x(), n * up.y(), n * kB * kB / (kA * kA) * up.z());
  p += origin.height_m * up + enu_m.x() * east + enu_m.y() * north + enu_m.z() * up;
  const double off_axis = std::hypot(p.x(), p.y());
  double found = std::atan2(p.z(), off_axis * (1 - kE2));
  double height = 0;
  for (int i = 0; i < 10; ++i)
  {
    const double normal = kA / std::sqrt(1 - kE2 * std::sin(found) * std::sin(found));
    height = off_axis / std::cos(found) - normal;
    found = std::atan2(p.z(), off_axis * (1 - kE2 * normal / (normal + height)));
  }
  return {found / kRad, std::atan2(p.y(), p.x()) / kRad, height};
}
}  // namespace traverse::testing
