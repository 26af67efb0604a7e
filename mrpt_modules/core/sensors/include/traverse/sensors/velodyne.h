// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace traverse::sensors
{
/** The Velodyne sensors that are understood. */
enum class VelodyneModel : uint8_t
{
  hdl32e,
  vlp16,
  vlp32c,
};

inline constexpr size_t kVelodyneModels = 3;

/** Name in messages: HDL-32E, VLP-16, VLP-32C. */
std::string_view nameOf(VelodyneModel model);

/** Which returns of a beam a packet carries; the values are those of the packet's factory byte. */
enum class ReturnMode : uint8_t
{
  strongest = 0x37,
  last = 0x38,
  dual = 0x39,  //!< block pairs: the last return, then the strongest (or the second strongest)
};

inline constexpr size_t kVelodynePacketBytes = 1206;
inline constexpr size_t kVelodynePositionBytes = 512;  //!< GPS packets on port 8308: no data
inline constexpr int kVelodyneBlocks = 12;
inline constexpr int kVelodyneRecords = 32;  //!< per block

/** The bytes of one UDP payload, unchecked; see VelodyneData. */
using VelodynePacket = std::span<const uint8_t>;

/** Where each laser looks. */
struct VelodyneCalibration
{
  struct Laser
  {
    double azimuth_offset_rad = 0;  //!< added to the encoder's azimuth, clockwise from above; the
                                    //!< negative of rotCorrection in Velodyne's db.xml
    double elevation_rad = 0;       //!< above the sensor's horizontal plane; db.xml: vertCorrection
    double distance_offset_m = 0;   //!< added to the measured distance
    double vertical_offset_m = 0;   //!< of the laser from the sensor's origin, along its own up
    double horizontal_offset_m = 0;  //!< likewise, to the left of its own forward direction
  };

  std::vector<Laser> lasers;  //!< by the laser's number in the packet; more than needed is fine
  double distance_unit_m = 0.002;  //!< metres per count of a distance
};

/** The manufacturer's nominal table. */
const VelodyneCalibration& factoryCalibration(VelodyneModel model);

/** True where a calibration (of a log: untrusted) has all lasers of the model and sane, finite
 * numbers: angles within a turn, offsets within 10 m, a distance unit above 0 and up to 0.1 m. */
bool fits(const VelodyneCalibration& calibration, VelodyneModel model);

/** Ring of each laser, 0 = lowest elevation; lasers of equal elevation in their own order. */
std::vector<uint16_t> ringsOf(const VelodyneCalibration& calibration, VelodyneModel model);
}  // namespace traverse::sensors
