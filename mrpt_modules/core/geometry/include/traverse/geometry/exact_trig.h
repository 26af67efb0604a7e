// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <limits>

// Angles with the same bits on every processor. libm's sin, cos, atan2 ... choose their code by
// processor and differ in the last bit. Here only + - * / and the square root of IEEE doubles in a
// fixed order take part (the compiler may not contract: -ffp-contract=off), and each of them has
// one correct result.
namespace traverse::geometry
{
/** Sine and cosine of one angle. */
struct SinCos
{
  double sin = 0;
  double cos = 1;
};

inline constexpr double kPi = 3.14159265358979323846;

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

/** Arc tangent of 0 <= t <= 1: halved twice, then 12 terms of the series, the first one left out
 * below 1e-17. */
inline double arcTangent(double t)
{
  for (int halving = 0; halving < 2; ++halving)
  {
    t = t / (1 + std::sqrt(1 + t * t));
  }
  const double t2 = t * t;
  double sum = 0;
  for (int n = 23; n >= 1; n -= 2)
  {
    sum = 1.0 / n - t2 * sum;
  }
  return 4 * t * sum;
}
}  // namespace detail

/** Sine and cosine, |angle_rad| <= 100; to 2e-15 within a turn, to 2e-14 beyond. */
constexpr SinCos sinCosOf(double angle_rad)
{
  const double quarters = angle_rad / (kPi / 2);
  const int nearest = static_cast<int>(quarters < 0 ? quarters - 0.5 : quarters + 0.5);
  return detail::turnedByQuarters(detail::sinCosOfEighth(angle_rad - nearest * (kPi / 2)), nearest);
}

/** Tangent, |angle_rad| < pi/2. */
constexpr double tangentOf(double angle_rad)
{
  const SinCos v = sinCosOf(angle_rad);
  return v.sin / v.cos;
}

/** sinCosOf() for angles of untrusted data: any that is finite, NaN for others. */
inline SinCos sinCosOfAny(double angle_rad)
{
  if (!std::isfinite(angle_rad))
  {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    return {kNone, kNone};
  }
  return sinCosOf(std::abs(angle_rad) <= 100 ? angle_rad : std::remainder(angle_rad, 2 * kPi));
}

/** atan2(y, x), in [-pi, pi], to 1e-15; 0 for (0, 0), NaN where one is NaN or both are infinite. */
inline double angleOf(double y, double x)
{
  const double across = std::abs(y);
  const double along = std::abs(x);
  if (across == 0 && along == 0)
  {
    return 0;
  }
  const bool steep = across > along;
  const double first = detail::arcTangent(steep ? along / across : across / along);
  const double upper = steep ? kPi / 2 - first : first;
  const double half = x < 0 ? kPi - upper : upper;
  return y < 0 ? -half : half;
}

/** asin(v) of -1 <= v <= 1, rad, to 1e-15. */
inline double arcSine(double v)
{
  return angleOf(v, std::sqrt((1 - v) * (1 + v)));
}
}  // namespace traverse::geometry
