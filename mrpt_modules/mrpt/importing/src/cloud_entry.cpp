// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "entries.h"

#include <traverse/observations/convert.h>

#include <mrpt/maps/CColouredPointsMap.h>
#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationRobotPose.h>

#include <algorithm>
#include <cmath>

namespace traverse::importing
{
namespace
{
mrpt::maps::CPointsMap::Ptr makeMap(const formats::CloudFile& cloud)
{
  if (cloud.intensity.empty() && !cloud.rgb.empty())
  {
    return mrpt::maps::CColouredPointsMap::Create();
  }
  return mrpt::maps::CPointsMapXYZI::Create();
}

/** Adds point i with its intensity or colour. */
void addPoint(
    const formats::CloudFile& cloud,
    size_t i,
    const Eigen::Vector3f& p,
    double intensity_scale,
    mrpt::maps::CPointsMap& map)
{
  if (dynamic_cast<mrpt::maps::CColouredPointsMap*>(&map) != nullptr)
  {
    constexpr float kByte = 255;
    const uint32_t rgb = cloud.rgb[i];
    map.insertPointRGB(
        p.x(), p.y(), p.z(), static_cast<float>(rgb >> 16U & 0xFFU) / kByte,
        static_cast<float>(rgb >> 8U & 0xFFU) / kByte, static_cast<float>(rgb & 0xFFU) / kByte);
    return;
  }
  double intensity = cloud.intensity.empty() ? 0 : cloud.intensity[i] * intensity_scale;
  intensity = std::isfinite(intensity) ? std::clamp(intensity, 0.0, 1.0) : 0;
  const auto level = static_cast<float>(intensity);
  map.insertPointRGB(p.x(), p.y(), p.z(), level, level, level);
}
}  // namespace

double intensityScale(const formats::CloudFile& cloud)
{
  float largest = 0;
  for (const float v : cloud.intensity)
  {
    largest = v > largest && std::isfinite(v) ? v : largest;
  }
  if (largest <= 1)
  {
    return 1;
  }
  return largest <= 255 ? 1.0 / 255 : 1.0 / 65535;
}

Entry cloudEntry(const formats::CloudFile& cloud, const SensorAt& sensor, const CloudFrame& frame)
{
  const auto map = makeMap(cloud);
  map->reserve(cloud.size());
  Entry entry;
  for (size_t i = 0; i < cloud.size(); ++i)
  {
    const Eigen::Vector3f p =
        (frame.T_sensor_file * Eigen::Vector3d(cloud.x[i], cloud.y[i], cloud.z[i])).cast<float>();
    if (!p.allFinite())
    {
      continue;
    }
    addPoint(cloud, i, p, frame.intensity_scale, *map);
    if (!cloud.ring.empty())
    {
      entry.channels.ring.push_back(cloud.ring[i]);
    }
    if (!cloud.time_s.empty())
    {
      entry.channels.time_s.push_back(cloud.time_s[i]);
    }
  }
  auto observation = mrpt::obs::CObservationPointCloud::Create();
  observation->sensorLabel = sensor.label;
  observation->sensorPose = observations::toPose3D(sensor.T_base_sensor);
  observation->timestamp = observations::toTimePoint(sensor.stamp);
  observation->pointcloud = map;
  entry.observation = observation;
  return entry;
}

Entry poseEntry(const poses::StampedPose& pose, const std::string& label)
{
  auto observation = mrpt::obs::CObservationRobotPose::Create();
  observation->sensorLabel = label;
  observation->timestamp = observations::toTimePoint(pose.time);
  observation->pose.mean = observations::toPose3D(pose.T_map_base);
  // Recordings do not say how good it is; a singular covariance would break those who weigh by it.
  observation->pose.cov.setDiagonal(1e-4);
  return {observation, {}};
}
}  // namespace traverse::importing
