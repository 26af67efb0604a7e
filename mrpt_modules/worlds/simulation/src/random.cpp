// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/simulation/random.h>

#include <cmath>

namespace traverse::simulation
{
namespace
{
uint64_t scrambled(uint64_t z)
{
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  return z ^ (z >> 31U);
}

/** Natural logarithm of 0 < v < 1 by the series of artanh: + - * / only. */
double logarithm(double v)
{
  constexpr double kLogOf2 = 0.693147180559945309417;
  int exponent = 0;
  const double mantissa = std::frexp(v, &exponent);  // exact; in [0.5, 1)
  const double t = (mantissa - 1) / (mantissa + 1);  // |t| <= 1/3
  double sum = 0;
  for (int n = 33; n >= 1; n -= 2)
  {
    sum = 1.0 / n + t * t * sum;
  }
  return exponent * kLogOf2 + 2 * t * sum;
}
}  // namespace

uint64_t mixed(std::initializer_list<uint64_t> words)
{
  uint64_t all = 0x9E3779B97F4A7C15U;
  for (const uint64_t word : words)
  {
    all = scrambled(all ^ word) + 0x9E3779B97F4A7C15U;
  }
  return scrambled(all);
}

uint64_t Random::bits()
{
  state_ += 0x9E3779B97F4A7C15U;
  return scrambled(state_);
}

double Random::uniform()
{
  return static_cast<double>(bits() >> 11U) * 0x1p-53;
}

double Random::normal()
{
  while (true)
  {
    const double u = uniform(-1, 1);
    const double v = uniform(-1, 1);
    const double s = u * u + v * v;
    if (s > 0 && s < 1)
    {
      return u * std::sqrt(-2 * logarithm(s) / s);
    }
  }
}
}  // namespace traverse::simulation
