// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/multi_lidar_grid/sensors.h>

#include <algorithm>
#include <bit>

namespace traverse::multi_lidar_grid
{
namespace
{
constexpr uint32_t kStuckAfter = 3;    // repeats: four equal clouds
constexpr double kOverdue = 2;         // times the usual time between clouds
constexpr double kDeadAfter = 10;      // time-outs
constexpr double kPeriodWeight = 0.2;  // of the newest gap in the usual one

/** Of a sample of the points: real sensors never send the same noise twice. */
uint64_t hashOf(const points::Scan& scan)
{
  constexpr size_t kSample = 512;
  const size_t step = scan.size() / kSample + 1;
  uint64_t hash = scan.size();
  for (size_t i = 0; i < scan.size(); i += step)
  {
    for (const float value : {scan.x[i], scan.y[i], scan.z[i]})
    {
      hash = (hash ^ std::bit_cast<uint32_t>(value)) * 0x9E3779B97F4A7C15U;
      hash ^= hash >> 29U;
    }
  }
  return hash;
}

void noteRepeats(Sensor& sensor, const points::Scan& scan, const Eigen::Vector3d& place)
{
  const uint64_t hash = hashOf(scan);
  const bool is_same =
      sensor.clouds + sensor.refused > 0 && scan.size() > 0 && hash == sensor.last_hash;
  sensor.repeats = is_same ? sensor.repeats + 1 : 0;
  sensor.repeats_at = is_same ? sensor.repeats_at : place;
  sensor.last_hash = hash;
}

void noteTime(Sensor& sensor, poses::TimeNs stamp)
{
  const double gap_s = poses::secondsBetween(sensor.newest, stamp);
  if (sensor.clouds == 1)
  {
    sensor.period_s = gap_s;
  }
  else if (sensor.clouds > 1)
  {
    sensor.period_s += kPeriodWeight * (std::min(gap_s, 2 * sensor.period_s) - sensor.period_s);
  }
  sensor.newest = stamp;
}
}  // namespace

std::string_view nameOf(Health health)
{
  constexpr std::array<std::string_view, 5> kNames = {"ok", "late", "stale", "dead", "stuck"};
  return kNames[static_cast<size_t>(health)];
}

Sensor& Sensors::obtain(std::string_view label, int32_t region_edge)
{
  const auto found = std::find_if(
      sensors_.begin(), sensors_.end(), [&](const Sensor& s) { return s.label == label; });
  if (found != sensors_.end())
  {
    return *found;
  }
  if (sensors_.size() == kMost)
  {
    return sensors_.back();
  }
  return sensors_.emplace_back(Sensor(label, region_edge));
}

uint32_t Sensors::bitOf(const Sensor& sensor) const
{
  uint32_t bit = 1;
  for (const Sensor& other : sensors_)
  {
    if (&other == &sensor)
    {
      return bit;
    }
    bit <<= 1U;
  }
  return 0;
}

Health healthOf(const Sensor& sensor, poses::TimeNs now, const Params& params)
{
  const double silent_s = poses::secondsBetween(sensor.newest, now);
  const double timeout_s = sensorParams(params, sensor.label).timeout_s;
  if (silent_s > kDeadAfter * timeout_s)
  {
    return Health::dead;
  }
  if (silent_s > timeout_s)
  {
    return Health::stale;
  }
  if (sensor.repeats >= kStuckAfter)
  {
    return Health::stuck;
  }
  const bool is_overdue = sensor.period_s > 0 && silent_s > kOverdue * sensor.period_s;
  return is_overdue ? Health::late : Health::ok;
}

Refusal arrive(
    Sensor& sensor,
    const points::Scan& scan,
    poses::TimeNs stamp,
    const Eigen::Vector3d& place,
    const Params& params)
{
  noteRepeats(sensor, scan, place);
  const bool is_newest = sensor.clouds == 0 || stamp > sensor.newest;
  if (!is_newest && poses::secondsBetween(stamp, sensor.newest) > params.order_window_s)
  {
    ++sensor.refused;
    return Refusal::too_late;
  }
  const bool moved = (place - sensor.repeats_at).norm() > params.cell_size_m;
  if (sensor.repeats >= kStuckAfter && moved)
  {
    ++sensor.refused;
    return Refusal::stuck;
  }
  if (is_newest)
  {
    noteTime(sensor, stamp);
  }
  ++sensor.clouds;
  return Refusal::none;
}
}  // namespace traverse::multi_lidar_grid
