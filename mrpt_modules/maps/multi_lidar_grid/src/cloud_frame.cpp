// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_frame.h"

#include <traverse/geometry/exact_trig.h>

#include <algorithm>
#include <cmath>

namespace traverse::multi_lidar_grid
{
namespace
{
constexpr double kMm = geometry::kMillimetresPerMetre;
constexpr double kZeroStep_mm = 100'000;

void setView(const Cloud& cloud, const SensorParams& sensor, BeamFrame& frame)
{
  const double width_deg = sensor.last_azimuth_deg - sensor.first_azimuth_deg;
  const Eigen::Matrix3d R_map_sensor =
      cloud.path.pose().linear() * cloud.scan.T_base_sensor.linear();
  if (!(width_deg < 360) || !R_map_sensor.allFinite())
  {
    return;
  }
  const geometry::SinCos first = geometry::sinCosOf(sensor.first_azimuth_deg * geometry::kPi / 180);
  const geometry::SinCos last = geometry::sinCosOf(sensor.last_azimuth_deg * geometry::kPi / 180);
  const Eigen::Vector3d after_first = R_map_sensor * Eigen::Vector3d(-first.sin, first.cos, 0);
  const Eigen::Vector3d before_last = R_map_sensor * Eigen::Vector3d(last.sin, -last.cos, 0);
  frame.has_view = true;
  frame.is_wide = width_deg > 180;
  for (int i = 0; i < 3; ++i)
  {
    frame.first_normal[static_cast<size_t>(i)] = static_cast<float>(after_first[i]);
    frame.last_normal[static_cast<size_t>(i)] = static_cast<float>(before_last[i]);
  }
}

void setOrigins(const SensorPath& path, BeamFrame& frame)
{
  const size_t count = std::min(path.origins().size(), BeamFrame::kMostOrigins);
  frame.origins = static_cast<int32_t>(count);
  frame.first_s = static_cast<float>(path.first_s());
  frame.by_step = static_cast<float>(1 / path.step_s());
  for (size_t i = 0; i < count; ++i)
  {
    const Eigen::Vector3d& p = path.origins()[i];
    frame.x_m[i] = static_cast<float>(p.x() - frame.min_x_mm / kMm);
    frame.y_m[i] = static_cast<float>(p.y() - frame.min_y_mm / kMm);
    frame.z_m[i] = static_cast<float>(p.z() - frame.zero_mm / kMm);
  }
}
}  // namespace

BeamFrame frameOf(
    const Cloud& cloud,
    const SensorParams& sensor,
    const geometry::CellRect& region,
    const Rules& rules)
{
  BeamFrame frame;
  const Eigen::Isometry3d& T = cloud.path.pose();
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      frame.to_map[row][column] = T.matrix()(row, column);
    }
  }
  frame.min_x_mm = static_cast<double>(region.min.x) * rules.cell_mm;
  frame.min_y_mm = static_cast<double>(region.min.y) * rules.cell_mm;
  frame.zero_mm = std::round(T.translation().z() * kMm / kZeroStep_mm) * kZeroStep_mm;
  frame.cell_mm = rules.cell_mm;
  frame.edge = region.width();
  frame.range2_m2 = sensor.range_m * sensor.range_m;
  frame.least2_m2 = static_cast<double>(rules.cell_m()) * rules.cell_m() / 4;
  setOrigins(cloud.path, frame);
  setView(cloud, sensor, frame);
  return frame;
}

Eigen::Vector3f localOrigin(const Cloud& cloud, const BeamFrame& frame, float time_s)
{
  const Eigen::Vector3d corner(frame.min_x_mm / kMm, frame.min_y_mm / kMm, frame.zero_mm / kMm);
  return (cloud.path.originAt(time_s) - corner).cast<float>();
}
}  // namespace traverse::multi_lidar_grid
