// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/traversability_grid/scan_source.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace traverse::traversability_grid
{
namespace
{
constexpr double kMmPerM = geometry::kMillimetresPerMetre;
constexpr double kUnitsPerMm2 = 100;   // (0.1 mm)^2
constexpr double kMostVariance = 1e8;  // one metre: more says nothing, and sums of it must fit

/** A beam that meets something at its sensor's own height meets no ground, unless that rises just
 * there: 5 cm and half a percent of the way are for the sensor's tilt and noise. */
bool isLevel(double up_mm, double along_mm2)
{
  constexpr double kBand_mm = 50;
  constexpr double kTilt = 0.005;
  const double beyond = std::abs(up_mm) - kBand_mm;
  return beyond <= 0 || beyond * beyond <= kTilt * kTilt * along_mm2;
}
}  // namespace

ScanSource::ScanSource(
    const points::Scan& scan,
    const Eigen::Isometry3d& T_map_base,
    uint32_t sensor_bit,
    const Params& params) :
    stamp_(scan.stamp), sensor_bit_(sensor_bit)
{
  const Eigen::Vector3d sensor = T_map_base * scan.T_base_sensor.translation();
  has_place_ = sensor.allFinite();
  x_mm_ = sensor.x() * kMmPerM;
  y_mm_ = sensor.y() * kMmPerM;
  z_mm_ = sensor.z() * kMmPerM;
  const double range_mm = params.range_noise_m * kMmPerM;
  const double angle = params.angle_noise_deg * std::numbers::pi / 180;
  range_variance_ = range_mm * range_mm * kUnitsPerMm2;
  angle_variance_ = angle * angle * kUnitsPerMm2;
}

layers::HeightSlab ScanSource::sumsOf(const ScanSlab& slab, int32_t cell_mm, int32_t slab_mm) const
{
  layers::HeightSlab sums = slab.sums(stamp_);
  sums.seen_by = sensor_bit_;
  if (!has_place_)
  {
    return sums;
  }
  const double dx = (slab.cell.x + 0.5) * cell_mm - x_mm_;
  const double dy = (slab.cell.y + 0.5) * cell_mm - y_mm_;
  const double dz = (slab.level + 0.5) * slab_mm - z_mm_;
  const double along = dx * dx + dy * dy;
  const double up = dz * dz;
  const double variance =
      range_variance_ * up / std::max(1.0, along + up) + angle_variance_ * along;
  sums.noise = static_cast<int64_t>(std::min(variance, kMostVariance)) * sums.n;
  const double z = slab.level * static_cast<double>(slab_mm) + static_cast<double>(sums.z) / sums.n;
  sums.level_n = isLevel(z - z_mm_, along) ? sums.n : 0;
  return sums;
}
}  // namespace traverse::traversability_grid
