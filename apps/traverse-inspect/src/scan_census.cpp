// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_census.h"

#include <traverse/points/sensor_origin.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace traverse::app
{
namespace
{
void measureRanges(ScanSensor& sensor)
{
  const points::ScanBuffer& scan = sensor.first.scan;
  const Eigen::Vector3d origin = points::sensorOrigin(scan.T_base_sensor);
  std::vector<double> ranges(scan.size());
  for (size_t i = 0; i < scan.size(); ++i)
  {
    ranges[i] = (Eigen::Vector3d(scan.x[i], scan.y[i], scan.z[i]) - origin).norm();
  }
  std::sort(ranges.begin(), ranges.end());
  sensor.nearest_m = ranges.front();
  sensor.median_m = ranges[ranges.size() / 2];
  sensor.farthest_m = ranges.back();
}
}  // namespace

void addTo(ScanCensus& census, points::Decoded decoded)
{
  const std::string& label = decoded.scan.sensor_label;
  if (census.size() >= kMostScanSensors && census.count(label) == 0)
  {
    return;
  }
  ScanSensor& sensor = census[label];
  ++sensor.scans;
  sensor.points += decoded.scan.size();
  sensor.rejects += decoded.rejects;
  sensor.empty += decoded.scan.size() == 0 ? 1 : 0;
  if (decoded.scan.size() > 0 && sensor.first.scan.size() == 0)
  {
    sensor.first = std::move(decoded);
    measureRanges(sensor);
  }
}
}  // namespace traverse::app
