// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/sensors/exact_angle.h>
#include <traverse/sensors/velodyne_timing.h>
#include <traverse/simulation/motion.h>

#include <array>
#include <cstdint>
#include <vector>

namespace traverse::simulation
{
/** What is the same for a laser in every firing sequence. */
struct SimulatedLaser
{
  sensors::SinCos elevation;
  sensors::AzimuthUnits azimuth_offset = 0;
  int64_t firing_ns = 0;  //!< since its sequence began
};

/** By the laser's number, from the manufacturer's table (whose offsets of distance and place are
 * zero). */
std::vector<SimulatedLaser> lasersOf(sensors::VelodyneModel model);

/** Where a sensor that turns evenly looks. */
class Encoder
{
 public:
  Encoder(double phase_deg, int64_t turn_ns);

  /** Clockwise, since_ns after the beginning of a turn. */
  sensors::AzimuthUnits azimuth(int64_t since_ns) const;

  /** As it stands in a packet. */
  static uint16_t hundredths(sensors::AzimuthUnits azimuth);

 private:
  sensors::AzimuthUnits phase_;
  int64_t turn_ns_;
};

/** A sensor's pose while a firing sequence lasts: evenly from one to another, which a turn of less
 * than a second leaves a rotation to 1e-8. Plain numbers: one fixed order of operations. */
class MovingPlacement
{
 public:
  MovingPlacement(const Eigen::Isometry3d& at_begin, const Eigen::Isometry3d& at_end);

  /** fraction 0..1 of the way. */
  Eigen::Vector3d origin(double fraction) const;

  Eigen::Vector3d direction(const Eigen::Vector3d& in_sensor, double fraction) const;

 private:
  std::array<double, 12> begin_{};
  std::array<double, 12> change_{};
};
}  // namespace traverse::simulation
