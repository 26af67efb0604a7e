// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/sensors/exact_angle.h>
#include <traverse/sensors/velodyne.h>

#include <array>
#include <cstdint>

namespace traverse::points
{
/** What is the same for a record in every packet. */
struct VelodyneBeam
{
  sensors::SinCos elevation;
  double distance_offset_m = 0;
  double vertical_offset_m = 0;
  double horizontal_offset_m = 0;
  float elevation_rad = 0;
  bool has_offsets = false;                  //!< vertical or horizontal
  sensors::AzimuthUnits azimuth_offset = 0;  //!< of the laser, clockwise, 0..kUnitsPerTurn-1
  int64_t firing_ns = 0;                     //!< since its group's first firing
  int64_t part_of_step = 0;                  //!< firing_ns / block_ns, in 2^-kPartBits
  uint16_t ring = 0;
  int sequence = 0;  //!< in its block

  static constexpr int kPartBits = 24;
};

/** One beam per record of a block. */
using VelodyneBeams = std::array<VelodyneBeam, sensors::kVelodyneRecords>;

/** The calibration must fit the model. */
VelodyneBeams beamsOf(
    const sensors::VelodyneCalibration& calibration, sensors::VelodyneModel model);
}  // namespace traverse::points
