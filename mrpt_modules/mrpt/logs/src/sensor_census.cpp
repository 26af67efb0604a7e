// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sensor_census.h"

#include <traverse/options/untrusted_text.h>

#include <algorithm>

namespace traverse::logs
{
namespace
{
constexpr size_t kMostSensors = 256;
constexpr size_t kLongest = 200;  // bytes of a name

/** The same place, or both none. */
bool same(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b)
{
  const bool finite = a.matrix().allFinite();
  return finite == b.matrix().allFinite() && (!finite || a.isApprox(b, 1e-9));
}
}  // namespace

SensorCensus::Place& SensorCensus::placeOf(
    const SightingFrame& sighting, std::vector<SensorTimes>& sensors)
{
  std::pair<std::string, std::string> key = {
      options::printable(sighting.label, kLongest), options::printable(sighting.type, kLongest)};
  if (places_.size() >= kMostSensors && places_.count(key) == 0)
  {
    key = {"others", "others"};
  }
  const auto [place, is_new] = places_.try_emplace(key, Place{sensors.size()});
  if (is_new)
  {
    SensorTimes& sensor = sensors.emplace_back();
    sensor.label = key.first;
    sensor.type = key.second;
    sensor.T_base_sensor = sighting.T_base_sensor;
  }
  return place->second;
}

void SensorCensus::add(const SightingFrame& sighting, std::vector<SensorTimes>& sensors)
{
  Place& place = placeOf(sighting, sensors);
  SensorTimes& sensor = sensors[place.index];
  ++sensor.count;
  sensor.sensor_pose_changes =
      sensor.sensor_pose_changes || !same(sensor.T_base_sensor, sighting.T_base_sensor);
  if (sighting.stamp == 0)
  {
    ++sensor.bad;
    return;
  }
  sensor.repeated += place.last == sighting.stamp ? 1 : 0;
  sensor.backward += place.last > sighting.stamp ? 1 : 0;
  place.last = sighting.stamp;
  sensor.first = sensor.first == 0 ? sighting.stamp : std::min(sensor.first, sighting.stamp);
  sensor.last = std::max(sensor.last, sighting.stamp);
  if (stamps_ < SensorTimes::kMostStamps)
  {
    sensor.stamps.push_back(sighting.stamp);
    ++stamps_;
  }
}
}  // namespace traverse::logs
