// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/sensors/velodyne.h>

#include <cstdint>

namespace traverse::sensors
{
/** How a model fires. All its lasers fire once in a sequence; then it recharges. */
struct VelodyneTiming
{
  int lasers;               //!< per sequence
  int sequences_per_block;  //!< lasers x sequences_per_block = kVelodyneRecords
  int64_t sequence_ns;      //!< from one sequence to the next
  int64_t slot_ns;          //!< from one firing to the next within a sequence
  int lasers_per_slot;      //!< that fire together
  float max_range_m;        //!< of the data sheet

  constexpr int64_t blockNs() const { return sequences_per_block * sequence_ns; }

  /** From the start of its sequence to the firing of a laser. */
  constexpr int64_t firingNs(int laser) const { return laser / lasers_per_slot * slot_ns; }
};

/** Of the manuals: HDL-32E (63-9113) appendix on firing times, VLP-16 (63-9243) chapter 9, VLP-32C
 * (63-9325) chapter 9. In dual mode a block pair takes the time of one block. */
constexpr VelodyneTiming timingOf(VelodyneModel model)
{
  switch (model)
  {
    case VelodyneModel::hdl32e:
      return {32, 1, 46'080, 1'152, 1, 100.0F};
    case VelodyneModel::vlp16:
      return {16, 2, 55'296, 2'304, 1, 100.0F};
    case VelodyneModel::vlp32c:
      return {32, 1, 55'296, 2'304, 2, 200.0F};
  }
  return {};
}
}  // namespace traverse::sensors
