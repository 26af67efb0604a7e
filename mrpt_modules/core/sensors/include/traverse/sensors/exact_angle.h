// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace traverse::sensors
{
/** Sine and cosine of one angle. */
struct SinCos
{
  double sin = 0;
  double cos = 1;
};

/** An azimuth as a whole number of 1/256 of a hundredth of a degree (6.8e-7 rad: 0.07 mm at 100 m),
 * clockwise seen from above as Velodyne counts it. Whole numbers make interpolation exact. */
using AzimuthUnits = int32_t;

inline constexpr AzimuthUnits kUnitsPerHundredth = 256;
inline constexpr AzimuthUnits kUnitsPerDegree = 100 * kUnitsPerHundredth;
inline constexpr AzimuthUnits kUnitsPerTurn = 360 * kUnitsPerDegree;
inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kRadPerDegree = kPi / 180;
inline constexpr double kRadPerUnit = kRadPerDegree / kUnitsPerDegree;

namespace detail
{
/** Taylor series for |r_rad| <= pi/4; the first term left out is below 1e-19. */
constexpr SinCos sinCosOfEighth(double r_rad)
{
  const double r2 = r_rad * r_rad;
  double s = 1;
  double c = 1;
  for (int n = 18; n >= 2; n -= 2)
  {
    c = 1 - r2 / (n * (n - 1)) * c;
    s = 1 - r2 / (n * (n + 1)) * s;
  }
  return {r_rad * s, c};
}

constexpr SinCos turnedByQuarters(SinCos v, int quarters)
{
  switch (quarters & 3)
  {
    case 0:
      return v;
    case 1:
      return {v.cos, -v.sin};
    case 2:
      return {-v.sin, -v.cos};
    default:
      return {-v.cos, v.sin};
  }
}

constexpr std::array<SinCos, 361> wholeDegrees()
{
  std::array<SinCos, 361> table{};
  for (int degree = 0; degree <= 360; ++degree)
  {
    const int quarters = (degree + 45) / 90;
    const double rest_rad = (degree - 90 * quarters) * kRadPerDegree;
    table[static_cast<size_t>(degree)] = turnedByQuarters(sinCosOfEighth(rest_rad), quarters);
  }
  return table;
}

inline constexpr std::array<SinCos, 361> kWholeDegrees = wholeDegrees();
}  // namespace detail

/** Sine and cosine to 2e-16, with the same bits on every processor; units in 0..kUnitsPerTurn-1.
 *
 * libm's sin and cos choose their code by processor and differ in the last bit. Here only + - * /
 * of IEEE doubles in a fixed order take part (the compiler may not contract: -ffp-contract=off),
 * and each of them has one correct result. So no rounding to a grid is needed. */
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

/** The same for any angle of a calibration, |angle_rad| <= 100. */
constexpr SinCos sinCosOf(double angle_rad)
{
  const double quarters = angle_rad / (kPi / 2);
  const int nearest = static_cast<int>(quarters < 0 ? quarters - 0.5 : quarters + 0.5);
  return detail::turnedByQuarters(detail::sinCosOfEighth(angle_rad - nearest * (kPi / 2)), nearest);
}

/** Brings any count of units into 0..kUnitsPerTurn-1. */
constexpr AzimuthUnits wrapped(AzimuthUnits units)
{
  const AzimuthUnits rest = units % kUnitsPerTurn;
  return rest < 0 ? rest + kUnitsPerTurn : rest;
}
}  // namespace traverse::sensors
