// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/exact_trig.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace traverse::sensors
{
using geometry::SinCos;
using geometry::sinCosOf;

/** An azimuth as a whole number of 1/256 of a hundredth of a degree (6.8e-7 rad: 0.07 mm at 100 m),
 * clockwise seen from above as Velodyne counts it. Whole numbers make interpolation exact. */
using AzimuthUnits = int32_t;

inline constexpr AzimuthUnits kUnitsPerHundredth = 256;
inline constexpr AzimuthUnits kUnitsPerDegree = 100 * kUnitsPerHundredth;
inline constexpr AzimuthUnits kUnitsPerTurn = 360 * kUnitsPerDegree;
using geometry::kPi;
inline constexpr double kRadPerDegree = kPi / 180;
inline constexpr double kRadPerUnit = kRadPerDegree / kUnitsPerDegree;

namespace detail
{
constexpr std::array<SinCos, 361> wholeDegrees()
{
  std::array<SinCos, 361> table{};
  for (int degree = 0; degree <= 360; ++degree)
  {
    const int quarters = (degree + 45) / 90;
    const double rest_rad = (degree - 90 * quarters) * kRadPerDegree;
    table[static_cast<size_t>(degree)] =
        geometry::detail::turnedByQuarters(geometry::detail::sinCosOfEighth(rest_rad), quarters);
  }
  return table;
}

inline constexpr std::array<SinCos, 361> kWholeDegrees = wholeDegrees();
}  // namespace detail

/** Sine and cosine to 2e-16, with the same bits on every processor (geometry/exact_trig.h), so that
 * no rounding to a grid is needed; units in 0..kUnitsPerTurn-1. */
constexpr SinCos sinCosOf(AzimuthUnits units)
{
  const int degree = (units + kUnitsPerDegree / 2) / kUnitsPerDegree;
  const double d = (units - degree * kUnitsPerDegree) * kRadPerUnit;  // |d| <= half a degree
  const double d2 = d * d;
  const double s = d * (1 - d2 * (1.0 / 6) * (1 - d2 * (1.0 / 20)));
  const double c = 1 - d2 * 0.5 * (1 - d2 * (1.0 / 12) * (1 - d2 * (1.0 / 30)));
  const SinCos& at = detail::kWholeDegrees[static_cast<size_t>(degree)];
  return {at.sin * c + at.cos * s, at.cos * c - at.sin * s};
}

/** Brings any count of units into 0..kUnitsPerTurn-1. */
constexpr AzimuthUnits wrapped(AzimuthUnits units)
{
  const AzimuthUnits rest = units % kUnitsPerTurn;
  return rest < 0 ? rest + kUnitsPerTurn : rest;
}
}  // namespace traverse::sensors
