// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lidar_return.h"

#include <traverse/sensors/velodyne_encode.h>
#include <traverse/sensors/velodyne_timing.h>

#include <algorithm>
#include <cmath>

namespace traverse::simulation
{
namespace
{
/** doc/simulation.md says where the figures come from. */
double halfRangeOf(const LidarParams& params)
{
  constexpr double kVlp32c = 600;
  constexpr double kOthers = 370;
  if (params.half_range_m >= 0)
  {
    return params.half_range_m;
  }
  return params.model == sensors::VelodyneModel::vlp32c ? kVlp32c : kOthers;
}
}  // namespace

Receiver::Receiver(const LidarParams& params, const std::vector<double>& biases_m) :
    biases_m_(biases_m),
    max_range_m_(
        params.max_range_m > 0 ? params.max_range_m
                               : static_cast<double>(sensors::timingOf(params.model).max_range_m)),
    unit_m_(sensors::factoryCalibration(params.model).distance_unit_m),
    noise_m_(params.range_noise_m),
    half_range_m_(halfRangeOf(params)),
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

NormalDraw Receiver::drawNoise(Random& random) const
{
  return noise_m_ > 0 ? random.drawNormal() : NormalDraw{};
}

Measured Receiver::measure(size_t laser, const Caught& caught, double noise) const
{
  if (!caught.is_any)
  {
    return {};
  }
  const uint16_t count =
      sensors::countOfDistance(caught.range_m + biases_m_[laser] + noise_m_ * noise, unit_m_);
  const double shown = std::clamp(std::floor(100 * caught.intensity + 0.5), 0.0, 255.0);
  return {{count, static_cast<uint8_t>(count > 0 ? shown : 0)}, caught.truth};
}

Caught Receiver::receive(const Hit& hit, Random& random) const
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
    constexpr double kFaint = 0.02;
    const double share = random.uniform();  // many near, few far
    const double range_m = kNearest + (kFarthest - kNearest) * share * share;
    if (range_m < hit.range_m && !(seen && last_))
    {
      const ReturnTruth drop{
          Scene::kNoObject, Label::none, Material::soil, static_cast<float>(range_m)};
      return {true, drop, range_m, kFaint, drawNoise(random)};
    }
  }
  if (!seen)
  {
    return {};
  }
  const ReturnTruth truth{hit.object, hit.label, hit.material, static_cast<float>(hit.range_m)};
  const double intensity = reflectivityOf(hit.material) * hit.cos_incidence;
  return {true, truth, hit.range_m, intensity, drawNoise(random)};
}
}  // namespace traverse::simulation
