// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "silent_beams.h"

#include "azimuth.h"

#include <traverse/geometry/exact_trig.h>
#include <traverse/points/range_image.h>

#include <algorithm>
#include <cmath>

namespace traverse::multi_lidar_grid
{
namespace
{
bool isWhole(const points::RangeImage& image)
{
  const size_t size = image.size();
  return image.columns > 0 && image.rows > 0 &&
         size == static_cast<size_t>(image.rows) * static_cast<size_t>(image.columns) &&
         image.azimuth_rad.size() == size && image.elevation_rad.size() == size;
}

bool inView(const SensorParams& sensor, double azimuth_rad)
{
  const double width_deg = sensor.last_azimuth_deg - sensor.first_azimuth_deg;
  const double from_first = azimuth_rad * 180 / geometry::kPi - sensor.first_azimuth_deg;
  return width_deg >= 360 || from_first - 360 * std::floor(from_first / 360) <= width_deg;
}
}  // namespace

void addSilentBeams(
    const Cloud& cloud, const SensorParams& sensor, const Rules& rules, BeamFans& fans)
{
  const points::RangeImage* image = cloud.scan.image;
  const Eigen::Matrix3d& R_base_sensor = cloud.scan.T_base_sensor.linear();
  if (!sensor.clears_without_return || image == nullptr || !isWhole(*image) ||
      !R_base_sensor.allFinite())
  {
    return;
  }
  double reach_m = std::min(rules.clearing_range_m, sensor.range_m);
  reach_m = image->max_range_m > 0 ? std::min<double>(reach_m, image->max_range_m) : reach_m;
  const bool has_times = image->time_s.size() == image->size();
  for (size_t i = 0; i < image->size(); ++i)
  {
    const double azimuth_rad = image->azimuth_rad[i];
    if (image->beam[i] != points::Beam::no_return || !inView(sensor, azimuth_rad))
    {
      continue;
    }
    const geometry::SinCos azimuth = geometry::sinCosOfAny(azimuth_rad);
    const geometry::SinCos elevation = geometry::sinCosOfAny(image->elevation_rad[i]);
    const float time_s = has_times ? image->time_s[i] : 0;
    const Eigen::Vector3d d =
        cloud.path.attitudeAt(time_s) *
        (R_base_sensor *
         Eigen::Vector3d(elevation.cos * azimuth.cos, elevation.cos * azimuth.sin, elevation.sin));
    const double along = std::sqrt(d.x() * d.x() + d.y() * d.y());
    if (!(along > 0.01))  // also where an angle was none
    {
      continue;
    }
    BeamFans::Empty empty;
    empty.turn = turnOf(static_cast<float>(d.x()), static_cast<float>(d.y()));
    empty.row = i / static_cast<size_t>(image->columns);
    empty.beam = {static_cast<float>(reach_m * along), static_cast<float>(d.z() / along), false};
    empty.time_s = time_s;
    fans.addEmpty(empty);
  }
}
}  // namespace traverse::multi_lidar_grid
