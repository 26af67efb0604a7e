// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>

namespace traverse::simulation
{
/** A random number in [-1, 1) of a node of the whole-number lattice. */
inline double nodeNoise(int64_t ix, int64_t iy, uint64_t seed)
{
  uint64_t z = seed * 0xD1B54A32D192ED03U + static_cast<uint64_t>(ix) * 0x9E3779B97F4A7C15U +
               static_cast<uint64_t>(iy) * 0xC2B2AE3D27D4EB4FU;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  z ^= z >> 31U;
  return static_cast<double>(z >> 11U) * 0x1p-52 - 1;
}

/** Smooth random heights in [-1, 1) with one independent value per unit square; two derivatives
 * are continuous. |x|, |y| < 1e9. */
inline double valueNoise(double x, double y, uint64_t seed)
{
  const double fx = std::floor(x);
  const double fy = std::floor(y);
  const auto ix = static_cast<int64_t>(fx);
  const auto iy = static_cast<int64_t>(fy);
  const double u = x - fx;
  const double v = y - fy;
  const double su = u * u * u * (u * (u * 6 - 15) + 10);
  const double sv = v * v * v * (v * (v * 6 - 15) + 10);
  const double south = nodeNoise(ix, iy, seed) * (1 - su) + nodeNoise(ix + 1, iy, seed) * su;
  const double north =
      nodeNoise(ix, iy + 1, seed) * (1 - su) + nodeNoise(ix + 1, iy + 1, seed) * su;
  return south * (1 - sv) + north * sv;
}
}  // namespace traverse::simulation
