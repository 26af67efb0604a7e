// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_columns.h"
#include "convert.h"

#include <mrpt/maps/CColouredPointsMap.h>
#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include <cmath>

namespace traverse::ros_bags
{
namespace
{
void setPoints(mrpt::maps::CPointsMap& map, const CloudColumns& columns)
{
  map.resize(columns.x.size());
  for (size_t i = 0; i < columns.x.size(); ++i)
  {
    map.setPointFast(i, columns.x[i], columns.y[i], columns.z[i]);
  }
}

mrpt::maps::CPointsMap::Ptr withIntensity(const CloudColumns& columns, float full)
{
  auto map = mrpt::maps::CPointsMapXYZI::Create();
  setPoints(*map, columns);
  for (size_t i = 0; i < columns.intensity.size(); ++i)
  {
    const float v = columns.intensity[i] / full;
    map->setPointIntensity(i, std::isfinite(v) ? std::clamp(v, 0.0F, 1.0F) : 0.0F);
  }
  return map;
}

mrpt::maps::CPointsMap::Ptr withColour(const CloudColumns& columns)
{
  constexpr uint32_t kByte = 0xff;
  constexpr float kFull = 255;
  auto map = mrpt::maps::CColouredPointsMap::Create();
  setPoints(*map, columns);
  for (size_t i = 0; i < columns.rgb.size(); ++i)
  {
    const uint32_t rgb = columns.rgb[i];
    const auto level = [&](uint32_t shift)
    { return static_cast<float>(rgb >> shift & kByte) / kFull; };
    map->setPointColor_fast(i, level(16), level(8), level(0));
  }
  return map;
}

mrpt::maps::CPointsMap::Ptr mapOf(
    const CloudColumns& columns, const std::string& topic, Surroundings& around)
{
  if (!columns.intensity.empty())
  {
    if (!columns.rgb.empty())
    {
      around.notes().skipped(topic + ": colour of a cloud that has intensity too");
    }
    const float full = columns.intensity_full > 0 ? columns.intensity_full
                                                  : around.intensityScale(topic, columns.intensity);
    return withIntensity(columns, full);
  }
  if (!columns.rgb.empty())
  {
    return withColour(columns);
  }
  auto map = mrpt::maps::CSimplePointsMap::Create();
  setPoints(*map, columns);
  return map;
}
}  // namespace

importing::Entry fromCloud(const PointCloud& cloud, const Origin& origin, Surroundings& around)
{
  CloudColumns columns = readColumns(cloud, origin.stamp_ns);
  for (const std::string& note : columns.notes)
  {
    around.notes().skipped(origin.topic + ": " + note);
  }
  auto observation = mrpt::obs::CObservationPointCloud::Create();
  observation->pointcloud = mapOf(columns, origin.topic, around);
  observation->sensorPose = around.sensorPose(cloud.header.frame, origin.stamp_ns);
  return {observation, std::move(columns.channels)};
}
}  // namespace traverse::ros_bags
