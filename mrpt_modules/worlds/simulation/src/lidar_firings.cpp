// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lidar_firings.h"

#include <cmath>

namespace traverse::simulation
{
namespace
{
constexpr int kTurnHundredths = 36000;

sensors::AzimuthUnits unitsOf(double angle_deg)
{
  return static_cast<sensors::AzimuthUnits>(std::floor(angle_deg * sensors::kUnitsPerDegree + 0.5));
}
}  // namespace

std::vector<SimulatedLaser> lasersOf(sensors::VelodyneModel model)
{
  const sensors::VelodyneTiming timing = sensors::timingOf(model);
  std::vector<SimulatedLaser> lasers;
  lasers.reserve(static_cast<size_t>(timing.lasers));
  for (int i = 0; i < timing.lasers; ++i)
  {
    const auto& laser = sensors::factoryCalibration(model).lasers[static_cast<size_t>(i)];
    lasers.push_back(
        {geometry::sinCosOf(laser.elevation_rad),
         unitsOf(laser.azimuth_offset_rad / sensors::kRadPerDegree), timing.firingNs(i)});
  }
  return lasers;
}

Encoder::Encoder(double phase_deg, int64_t turn_ns) : phase_(unitsOf(phase_deg)), turn_ns_(turn_ns)
{
}

sensors::AzimuthUnits Encoder::azimuth(int64_t since_ns) const
{
  const int64_t units = since_ns % turn_ns_ * sensors::kUnitsPerTurn / turn_ns_;
  return sensors::wrapped(phase_ + static_cast<sensors::AzimuthUnits>(units));
}

uint16_t Encoder::hundredths(sensors::AzimuthUnits azimuth)
{
  return static_cast<uint16_t>(
      (azimuth + sensors::kUnitsPerHundredth / 2) / sensors::kUnitsPerHundredth % kTurnHundredths);
}

MovingPlacement::MovingPlacement(const Eigen::Isometry3d& at_begin, const Eigen::Isometry3d& at_end)
{
  size_t at = 0;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 4; ++column, ++at)
    {
      begin_[at] = at_begin.matrix()(row, column);
      change_[at] = at_end.matrix()(row, column) - begin_[at];
    }
  }
}

Eigen::Vector3d MovingPlacement::origin(double fraction) const
{
  const auto row = [&](size_t at) { return begin_[at + 3] + fraction * change_[at + 3]; };
  return {row(0), row(4), row(8)};
}

Eigen::Vector3d MovingPlacement::direction(const Eigen::Vector3d& in_sensor, double fraction) const
{
  const auto row = [&](size_t at)
  {
    return (begin_[at] + fraction * change_[at]) * in_sensor.x() +
           (begin_[at + 1] + fraction * change_[at + 1]) * in_sensor.y() +
           (begin_[at + 2] + fraction * change_[at + 2]) * in_sensor.z();
  };
  return {row(0), row(4), row(8)};
}
}  // namespace traverse::simulation
