// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace traverse::traversability_grid
{
/** Labels that a map knows apart; the bit after theirs stands for all others. */
inline constexpr size_t kMostSensors = 31;

constexpr uint32_t sensorBitOf(size_t number)
{
  return uint32_t{1} << (number < kMostSensors ? number : kMostSensors);
}

/** Bits of HeightSlab::seen_by counted by other numbers: bit i becomes bits[i], that of the others
 * stays. */
inline uint32_t renumbered(uint32_t seen_by, std::span<const uint32_t> bits)
{
  uint32_t out = seen_by & sensorBitOf(kMostSensors);
  for (size_t i = 0; i < bits.size(); ++i)
  {
    out |= ((seen_by >> i) & 1U) != 0 ? bits[i] : 0;
  }
  return out;
}
}  // namespace traverse::traversability_grid
