// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace traverse::simulation
{
inline constexpr uint64_t kNoiseColumn = 0x9E3779B97F4A7C15U;
inline constexpr uint64_t kNoiseRow = 0xC2B2AE3D27D4EB4FU;

/** A random number in [-1, 1) of a node of the whole-number lattice; `word` is the sum of its
 * column, row and seed, each times a large odd number. */
inline double nodeNoise(uint64_t word)
{
  word = (word ^ (word >> 32U)) * 0xD6E8FEB86659FD93U;
  word = (word ^ (word >> 32U)) * 0xD6E8FEB86659FD93U;
  return static_cast<double>(static_cast<int64_t>(word ^ (word >> 32U)) >> 11U) * 0x1p-52;
}

/** The whole number below. std::floor() is a call where SSE 4.1 may not be used. */
inline int64_t wholeBelow(double v)
{
  const auto whole = static_cast<int64_t>(v);
  return whole - (v < static_cast<double>(whole) ? 1 : 0);
}

/** Smooth random heights in [-1, 1) with one independent value per unit square; two derivatives
 * are continuous. |x|, |y| < 1e9. */
inline double valueNoise(double x, double y, uint64_t seed)
{
  const int64_t ix = wholeBelow(x);
  const int64_t iy = wholeBelow(y);
  const double u = x - static_cast<double>(ix);
  const double v = y - static_cast<double>(iy);
  const double su = u * u * u * (u * (u * 6 - 15) + 10);
  const double sv = v * v * v * (v * (v * 6 - 15) + 10);
  const uint64_t word = seed * 0xD1B54A32D192ED03U + static_cast<uint64_t>(ix) * kNoiseColumn +
                        static_cast<uint64_t>(iy) * kNoiseRow;
  const double a = nodeNoise(word);
  const double b = nodeNoise(word + kNoiseColumn);
  const double c = nodeNoise(word + kNoiseRow);
  const double d = nodeNoise(word + kNoiseColumn + kNoiseRow);
  const double south = a + (b - a) * su;
  const double north = c + (d - c) * su;
  return south + (north - south) * sv;
}
}  // namespace traverse::simulation
