// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "velodyne_beams.h"

#include <traverse/sensors/exact_angle.h>

#include <Eigen/Geometry>

#include <array>

namespace traverse::points
{
/** T_base_sensor as plain numbers: one fixed order of operations, whatever Eigen vectorises. */
class Placement
{
 public:
  explicit Placement(const Eigen::Isometry3d& T_base_sensor)
  {
    size_t at = 0;
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 4; ++column)
      {
        m_[at++] = T_base_sensor.matrix()(row, column);
      }
    }
  }

  std::array<float, 3> inBase(const std::array<double, 3>& p_sensor) const
  {
    return {row(0, p_sensor), row(4, p_sensor), row(8, p_sensor)};
  }

 private:
  float row(size_t at, const std::array<double, 3>& p) const
  {
    return static_cast<float>(m_[at] * p[0] + m_[at + 1] * p[1] + m_[at + 2] * p[2] + m_[at + 3]);
  }

  std::array<double, 12> m_{};
};

/** One firing of one laser: where it looked and when. */
struct Firing
{
  const VelodyneBeam& beam;
  sensors::AzimuthUnits azimuth;
  float time_s;
};

inline std::array<double, 3> inSensor(const Firing& firing, double distance_m)
{
  const VelodyneBeam& beam = firing.beam;
  const sensors::SinCos a = sensors::sinCosOf(firing.azimuth);
  const double along =
      distance_m * beam.elevation.cos - beam.vertical_offset_m * beam.elevation.sin;
  return {
      along * a.cos + beam.horizontal_offset_m * a.sin,
      beam.horizontal_offset_m * a.cos - along * a.sin,
      distance_m * beam.elevation.sin + beam.vertical_offset_m * beam.elevation.cos};
}
}  // namespace traverse::points
