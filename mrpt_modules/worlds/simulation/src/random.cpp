// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/simulation/random.h>

#include <array>
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

/** kLanes side by side, by Marsaglia's polar method with the natural logarithm of 0 < v < 1 as the
 * series of artanh: + - * / and a root only, in one order, so that lanes do not change bits. */
template <size_t kLanes>
void makeNormals(const NormalDraw* draws, double* normals)
{
  constexpr double kLogOf2 = 0.693147180559945309417;
  std::array<double, kLanes> exponent{};
  std::array<double, kLanes> t{};
  std::array<double, kLanes> square{};
  std::array<double, kLanes> sum{};
  for (size_t i = 0; i < kLanes; ++i)
  {
    int power = 0;
    const double mantissa = std::frexp(draws[i].square, &power);  // exact; in [0.5, 1)
    exponent[i] = power;
    t[i] = (mantissa - 1) / (mantissa + 1);  // |t| <= 1/3
    square[i] = t[i] * t[i];
  }
  for (int n = 33; n >= 1; n -= 2)
  {
    const double share = 1.0 / n;
    for (size_t i = 0; i < kLanes; ++i)
    {
      sum[i] = share + square[i] * sum[i];
    }
  }
  for (size_t i = 0; i < kLanes; ++i)
  {
    const double logarithm = exponent[i] * kLogOf2 + 2 * t[i] * sum[i];
    normals[i] = draws[i].u * std::sqrt(-2 * logarithm / draws[i].square);
  }
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

NormalDraw Random::drawNormal()
{
  while (true)
  {
    const double u = uniform(-1, 1);
    const double v = uniform(-1, 1);
    const double square = u * u + v * v;
    if (square > 0 && square < 1)
    {
      return {u, square};
    }
  }
}

double Random::normal()
{
  const NormalDraw draw = drawNormal();
  double normal = 0;
  makeNormals<1>(&draw, &normal);
  return normal;
}

void normalsOf(std::span<const NormalDraw> draws, std::span<double> normals)
{
  constexpr size_t kTogether = 16;
  size_t i = 0;
  for (; i + kTogether <= draws.size(); i += kTogether)
  {
    makeNormals<kTogether>(&draws[i], &normals[i]);
  }
  for (; i < draws.size(); ++i)
  {
    makeNormals<1>(&draws[i], &normals[i]);
  }
}
}  // namespace traverse::simulation
