// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/sensors/velodyne.h>

#include <array>
#include <cstdint>
#include <optional>

namespace traverse::sensors
{
/** One measurement as it stands in a packet; distance 0 is no return. */
struct VelodyneReturn
{
  uint16_t distance = 0;  //!< in VelodyneCalibration::distance_unit_m
  uint8_t intensity = 0;

  friend bool operator==(const VelodyneReturn&, const VelodyneReturn&) = default;
};

/** A data packet whose every field was checked; a view that owns no bytes.
 *
 * A *group* is what shares one azimuth: a block, or in dual mode a pair of blocks. */
class VelodyneData
{
 public:
  /** Nothing unless the bytes are a data packet of a known model: its length, the id and azimuth of
   * every block, equal azimuths in dual mode's pairs, and both factory bytes. Position packets and
   * anything hostile give nothing. */
  static std::optional<VelodyneData> check(VelodynePacket bytes);

  VelodyneModel model() const { return model_; }

  ReturnMode mode() const { return mode_; }

  /** Microseconds since the top of the hour of the first firing; a broken clock may give more than
   * an hour. */
  uint32_t timeUs() const { return time_us_; }

  int blocksPerGroup() const { return mode_ == ReturnMode::dual ? 2 : 1; }

  int groups() const { return kVelodyneBlocks / blocksPerGroup(); }

  /** Hundredths of a degree, 0..35999, clockwise, at the first firing of the group. */
  uint16_t azimuth(int group) const;

  /** Hundredths of a degree from the start of a group to that of the next one: of the group itself,
   * or, where that is no motion a sensor can make (or the group is the packet's last), of the
   * nearest group of the packet, earlier first; 0 where there is none. */
  uint16_t azimuthStep(int group) const;

  /** The record of a block, 0..11, in the packet's order: 0..31. */
  VelodyneReturn record(int block, int index) const
  {
    const size_t at = static_cast<size_t>(block) * 100 + 4 + static_cast<size_t>(index) * 3;
    return {static_cast<uint16_t>(bytes_[at] | bytes_[at + 1] << 8), bytes_[at + 2]};
  }

 private:
  VelodyneData() = default;

  /** Of the group itself; nothing where it is not plausible. */
  std::optional<uint16_t> ownStep(int group) const;

  VelodynePacket bytes_;
  VelodyneModel model_ = VelodyneModel::vlp16;
  ReturnMode mode_ = ReturnMode::strongest;
  uint32_t time_us_ = 0;
};
}  // namespace traverse::sensors
