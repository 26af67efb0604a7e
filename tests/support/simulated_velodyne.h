// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "velodyne_capture.h"

#include <traverse/points/velodyne_scan.h>
#include <traverse/sensors/velodyne_encode.h>
#include <traverse/sensors/velodyne_timing.h>

#include <functional>
#include <numbers>

namespace traverse::testing
{
/** A sensor that turns evenly, and what each beam meets. The azimuths it stores are rounded to
 * 0.01 degrees, as a sensor's are. */
struct SimulatedVelodyne
{
  sensors::VelodyneModel model = sensors::VelodyneModel::vlp16;
  sensors::ReturnMode mode = sensors::ReturnMode::strongest;
  double rate_dps = 3600;         //!< 10 Hz
  double start_deg = 0;           //!< azimuth at time 0
  uint32_t start_us = 1'000'000;  //!< of the hour

  /** Encoder azimuth at a time, clockwise. */
  double azimuthDeg(double t_s) const { return std::fmod(start_deg + rate_dps * t_s + 3600, 360); }

  /** Where a laser looks at a time: a unit vector in the sensor frame. */
  Eigen::Vector3d direction(int laser, double t_s) const
  {
    const auto& l = sensors::factoryCalibration(model).lasers[static_cast<size_t>(laser)];
    const double a = azimuthDeg(t_s) * std::numbers::pi / 180 + l.azimuth_offset_rad;
    return {
        std::cos(l.elevation_rad) * std::cos(a), -std::cos(l.elevation_rad) * std::sin(a),
        std::sin(l.elevation_rad)};
  }

  /** Counts of (laser, time) for both returns: last, strongest; see ReturnMode. */
  using World = std::function<std::array<sensors::VelodyneReturn, 2>(int laser, double t_s)>;

  Capture run(int packets, const World& world) const
  {
    const sensors::VelodyneTiming timing = sensors::timingOf(model);
    const int per_group = mode == sensors::ReturnMode::dual ? 2 : 1;
    const int64_t packet_ns = sensors::kVelodyneBlocks / per_group * timing.blockNs();
    Capture capture;
    for (int p = 0; p < packets; ++p)
    {
      sensors::VelodynePacketContent content;
      content.model = model;
      content.mode = mode;
      content.time_us =
          static_cast<uint32_t>((start_us + (p * packet_ns + 500) / 1000) % 3'600'000'000);
      for (int block = 0; block < sensors::kVelodyneBlocks; ++block)
      {
        const int64_t start_ns = p * packet_ns + block / per_group * timing.blockNs();
        fill(content.blocks[static_cast<size_t>(block)], start_ns, block % per_group, world);
      }
      const auto bytes = sensors::encodeVelodyne(content);
      capture.packets.emplace_back(bytes.begin(), bytes.end());
    }
    return capture;
  }

 private:
  void fill(
      sensors::VelodyneBlock& block, int64_t start_ns, int which_return, const World& world) const
  {
    const sensors::VelodyneTiming timing = sensors::timingOf(model);
    const double hundredths = azimuthDeg(1e-9 * static_cast<double>(start_ns)) * 100;
    block.azimuth = static_cast<uint16_t>(std::lround(hundredths) % 36000);
    for (int i = 0; i < sensors::kVelodyneRecords; ++i)
    {
      const int laser = i % timing.lasers;
      const int64_t t_ns =
          start_ns + i / timing.lasers * timing.sequence_ns + timing.firingNs(laser);
      block.records[static_cast<size_t>(i)] =
          world(laser, 1e-9 * static_cast<double>(t_ns))[static_cast<size_t>(which_return)];
    }
  }
};

inline points::Decoded decode(const Capture& capture, points::VelodyneInput input = {})
{
  const auto views = capture.views();
  input.packets = views;
  return points::decodeVelodyne(input);
}
}  // namespace traverse::testing
