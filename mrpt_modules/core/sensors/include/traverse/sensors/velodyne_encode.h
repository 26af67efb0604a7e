// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/sensors/velodyne_packet.h>

#include <array>
#include <span>

namespace traverse::sensors
{
/** What one block of a packet says. */
struct VelodyneBlock
{
  uint16_t azimuth = 0;  //!< hundredths of a degree, 0..35999, clockwise, at its first firing
  std::array<VelodyneReturn, kVelodyneRecords> records{};  //!< VLP-16: two sequences of 16
};

/** What one packet says; in dual mode blocks 2i and 2i + 1 are one firing: last, then strongest. */
struct VelodynePacketContent
{
  VelodyneModel model = VelodyneModel::vlp16;
  ReturnMode mode = ReturnMode::strongest;
  uint32_t time_us = 0;  //!< since the top of the hour, of the first firing
  std::array<VelodyneBlock, kVelodyneBlocks> blocks{};
};

/** The bytes a sensor would send; the inverse of VelodyneData. For simulators and tests. */
std::array<uint8_t, kVelodynePacketBytes> encodeVelodyne(const VelodynePacketContent& content);

/** The count that stands for a distance: the nearest one, 0 (no return) where the distance is not
 * above half a unit, not finite, or more than 65535 units. */
uint16_t countOfDistance(double distance_m, double distance_unit_m);
}  // namespace traverse::sensors
