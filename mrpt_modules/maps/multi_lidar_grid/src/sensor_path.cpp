// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/multi_lidar_grid/cloud.h>
#include <traverse/points/sensor_origin.h>

#include <cmath>

namespace traverse::multi_lidar_grid
{
namespace
{
constexpr size_t kOrigins = 16;

/** Turns last a tenth of a second; times that lie further from the stamp are none. */
constexpr float kLongest_s = 10;

struct TimeSpan
{
  float first_s = 0;
  float last_s = 0;
};

TimeSpan spanOf(std::span<const float> time_s)
{
  TimeSpan span;
  bool is_first = true;
  for (const float t : time_s)
  {
    if (!(std::abs(t) <= kLongest_s))
    {
      continue;
    }
    span.first_s = is_first ? t : std::min(span.first_s, t);
    span.last_s = is_first ? t : std::max(span.last_s, t);
    is_first = false;
  }
  return span;
}
}  // namespace

std::optional<SensorPath> SensorPath::along(
    const points::Scan& scan, poses::TimeNs stamp, const poses::PoseTrack& track)
{
  const auto at_stamp = track.at(stamp);
  if (!at_stamp || !at_stamp->T_map_base.matrix().allFinite())
  {
    return std::nullopt;
  }
  const Eigen::Vector3d p_base = points::sensorOrigin(scan.T_base_sensor);
  SensorPath path;
  path.T_map_base_ = at_stamp->T_map_base;
  path.origins_ = {path.T_map_base_ * p_base};
  path.attitudes_ = {path.T_map_base_.linear()};
  const TimeSpan span = spanOf(scan.time_s);
  if (!track.moves() || !(span.first_s < span.last_s))
  {
    return path;
  }
  path.first_s_ = span.first_s;
  path.step_s_ = (static_cast<double>(span.last_s) - span.first_s) / (kOrigins - 1);
  path.origins_.resize(kOrigins, path.origins_.front());
  path.attitudes_.resize(kOrigins, path.attitudes_.front());
  for (size_t i = 0; i < kOrigins; ++i)
  {
    const double time_s = path.first_s_ + path.step_s_ * static_cast<double>(i);
    const auto pose = track.at(poses::later(stamp, time_s));
    if (pose && pose->segment == at_stamp->segment)
    {
      path.origins_[i] = pose->T_map_base * p_base;
      path.attitudes_[i] = pose->T_map_base.linear();
    }
  }
  return path;
}
}  // namespace traverse::multi_lidar_grid
