// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/exact_trig.h>

#include <Eigen/Core>

namespace traverse::geometry
{
/** A place on WGS 84. */
struct Geodetic
{
  double latitude_deg = 0;   //!< north positive
  double longitude_deg = 0;  //!< east positive
  double height_m = 0;       //!< above the ellipsoid
};

/** Earth-centred coordinates, m (WGS 84), with the same bits on every processor. */
inline Eigen::Vector3d earthCentred(const Geodetic& place)
{
  constexpr double kSemiMajor_m = 6378137.0;
  constexpr double kFlattening = 1 / 298.257223563;
  constexpr double kEccentricity2 = kFlattening * (2 - kFlattening);
  const SinCos lat = sinCosOfAny(place.latitude_deg * (kPi / 180));
  const SinCos lon = sinCosOfAny(place.longitude_deg * (kPi / 180));
  const double normal_m = kSemiMajor_m / std::sqrt(1 - kEccentricity2 * lat.sin * lat.sin);
  const double off_axis_m = (normal_m + place.height_m) * lat.cos;
  return {
      off_axis_m * lon.cos, off_axis_m * lon.sin,
      (normal_m * (1 - kEccentricity2) + place.height_m) * lat.sin};
}

/** The tangent plane at a place: x east, y north, z up, m. */
class LocalPlane
{
 public:
  explicit LocalPlane(const Geodetic& origin) : origin_(earthCentred(origin))
  {
    const SinCos lat = sinCosOfAny(origin.latitude_deg * (kPi / 180));
    const SinCos lon = sinCosOfAny(origin.longitude_deg * (kPi / 180));
    R_enu_earth_ << -lon.sin, lon.cos, 0, -lat.sin * lon.cos, -lat.sin * lon.sin, lat.cos,
        lat.cos * lon.cos, lat.cos * lon.sin, lat.sin;
  }

  Eigen::Vector3d at(const Geodetic& place) const
  {
    return R_enu_earth_ * (earthCentred(place) - origin_);
  }

 private:
  Eigen::Vector3d origin_;
  Eigen::Matrix3d R_enu_earth_;
};
}  // namespace traverse::geometry
