// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lidar_return.h"

#include <traverse/sensors/velodyne_encode.h>
#include <traverse/sensors/velodyne_timing.h>

#include <algorithm>
#include <cmath>

namespace traverse::simulation
{
Receiver::Receiver(const LidarParams& params) :
    max_range_m_(
        params.max_range_m > 0 ? params.max_range_m
                               : static_cast<double>(sensors::timingOf(params.model).max_range_m)),
    unit_m_(sensors::factoryCalibration(params.model).distance_unit_m),
    noise_m_(params.range_noise_m),
    half_range_m_(params.half_range_m),
    drop_out_(params.drop_out),
    rain_share_(params.rain_share),
    last_(params.mode == sensors::ReturnMode::last)
{
}

/** The light that comes back falls with the range squared, the surface's reflectivity and the
 * cosine of incidence; about the threshold of the sensor a return is seen by chance. */
bool Receiver::isSeen(const Hit& hit, Random& random) const
{
  if (half_range_m_ <= 0)
  {
    return true;
  }
  const double relative = hit.range_m / half_range_m_;
  const double light = reflectivityOf(hit.material) * std::max(hit.cos_incidence, 1e-6);
  const double needed = relative * relative / light;  // 1: seen in half of the cases
  const double needed2 = needed * needed;
  return random.uniform() * (1 + needed2 * needed2) < 1;
}

Measured Receiver::record(
    const ReturnTruth& truth, double range_m, double intensity, Random& random) const
{
  const double noisy_m = noise_m_ > 0 ? range_m + noise_m_ * random.normal() : range_m;
  const uint16_t count = sensors::countOfDistance(noisy_m, unit_m_);
  const double shown = std::clamp(std::floor(100 * intensity + 0.5), 0.0, 255.0);
  return {{count, static_cast<uint8_t>(count > 0 ? shown : 0)}, truth};
}

/** Drops near the sensor: many near, few far, as light that comes back falls with the range. */
Measured Receiver::drop(double range_m, Random& random) const
{
  return record(
      {Scene::kNoObject, Label::none, Material::soil, static_cast<float>(range_m)}, range_m, 0.02,
      random);
}

Measured Receiver::measure(const Hit& hit, Random& random) const
{
  if (drop_out_ > 0 && random.chance(drop_out_))
  {
    return {};
  }
  const bool seen = hit.any() && isSeen(hit, random);
  if (rain_share_ > 0 && random.chance(rain_share_))
  {
    constexpr double kNearest = 0.5;
    constexpr double kFarthest = 15;
    const double share = random.uniform();
    const double range_m = kNearest + (kFarthest - kNearest) * share * share;
    if (range_m < hit.range_m && !(seen && last_))
    {
      return drop(range_m, random);
    }
  }
  if (!seen)
  {
    return {};
  }
  return record(
      {hit.object, hit.label, hit.material, static_cast<float>(hit.range_m)}, hit.range_m,
      reflectivityOf(hit.material) * hit.cos_incidence, random);
}
}  // namespace traverse::simulation
