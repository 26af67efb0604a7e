// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "velodyne_beams.h"

#include <traverse/sensors/velodyne_timing.h>

#include <cmath>

namespace traverse::points
{
namespace
{
VelodyneBeam beamOf(const sensors::VelodyneCalibration::Laser& laser)
{
  VelodyneBeam beam;
  beam.elevation = sensors::sinCosOf(laser.elevation_rad);
  beam.distance_offset_m = laser.distance_offset_m;
  beam.vertical_offset_m = laser.vertical_offset_m;
  beam.horizontal_offset_m = laser.horizontal_offset_m;
  beam.has_offsets = laser.vertical_offset_m != 0 || laser.horizontal_offset_m != 0;
  beam.elevation_rad = static_cast<float>(laser.elevation_rad);
  beam.azimuth_offset = sensors::wrapped(static_cast<sensors::AzimuthUnits>(
      std::lround(laser.azimuth_offset_rad / sensors::kRadPerUnit)));
  return beam;
}
}  // namespace

VelodyneBeams beamsOf(const sensors::VelodyneCalibration& calibration, sensors::VelodyneModel model)
{
  const sensors::VelodyneTiming timing = sensors::timingOf(model);
  const std::vector<uint16_t> rings = sensors::ringsOf(calibration, model);
  VelodyneBeams beams;
  for (int record = 0; record < sensors::kVelodyneRecords; ++record)
  {
    const int laser = record % timing.lasers;
    VelodyneBeam& beam = beams[static_cast<size_t>(record)];
    beam = beamOf(calibration.lasers[static_cast<size_t>(laser)]);
    beam.sequence = record / timing.lasers;
    beam.firing_ns = beam.sequence * timing.sequence_ns + timing.firingNs(laser);
    beam.part_of_step = (beam.firing_ns << VelodyneBeam::kPartBits) / timing.blockNs();
    beam.ring = rings[static_cast<size_t>(laser)];
  }
  return beams;
}
}  // namespace traverse::points
