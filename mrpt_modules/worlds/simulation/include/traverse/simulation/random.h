// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>

namespace traverse::simulation
{
/** One well mixed number from several: the same words give the same number, others an independent
 * one. For random numbers that depend on what they are for, not on what was drawn before. */
uint64_t mixed(std::initializer_list<uint64_t> words);

/** Random bits that a normal number is made of; as it is, of 0. */
struct NormalDraw
{
  double u = 0;
  double square = 0.5;  //!< in (0, 1)
};

/** Makes many at once, with the bits of Random::normal(). As many as there are draws. */
void normalsOf(std::span<const NormalDraw> draws, std::span<double> normals);

/** Random numbers that a seed gives on every machine: whole-number arithmetic and our own
 * distributions, neither the library's nor libm's (whose results differ between machines). The
 * generator is SplitMix64 (Steele, Lea, Flood, 2014); small, so one for each purpose. */
class Random
{
 public:
  explicit Random(uint64_t seed) : state_(seed) {}

  /** 64 random bits. */
  uint64_t bits();

  /** In [0, 1), a multiple of 2^-53. */
  double uniform();

  /** In [from, to). */
  double uniform(double from, double to) { return from + (to - from) * uniform(); }

  /** Normal, mean 0, standard deviation 1 (Marsaglia's polar method). */
  double normal();

  /** What normal() would be made of. */
  NormalDraw drawNormal();

  /** In [0, n), n > 0; every number as likely as the others to 2^-32. */
  uint32_t index(uint32_t n) { return static_cast<uint32_t>((bits() >> 32U) * n >> 32U); }

  /** True with this probability. */
  bool chance(double probability) { return uniform() < probability; }

 private:
  uint64_t state_;
};
}  // namespace traverse::simulation
