// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "decoders.h"

#include <traverse/points/range_row.h>

#include <mrpt/obs/CObservationRotatingScan.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <numeric>
#include <vector>

namespace traverse::observations
{
namespace
{
using mrpt::obs::CObservationRotatingScan;

/** Elevation of each row of the log, rad. */
std::vector<double> elevations(
    const CObservationRotatingScan& scan, const ObservationParams& params)
{
  const std::vector<double>& table = params.rotating_elevations_deg;
  if (table.empty() && scan.rowCount == 1)
  {
    return {0.0};
  }
  if (table.empty())
  {
    throw Refused(fmt::format(
        "the class carries no elevations; give those of its {} rows in rotating_elevations_deg",
        scan.rowCount));
  }
  if (table.size() != scan.rowCount)
  {
    throw Refused(
        fmt::format("it has {} rows, rotating_elevations_deg has {}", scan.rowCount, table.size()));
  }
  std::vector<double> all(table.size());
  std::transform(
      table.begin(), table.end(), all.begin(),
      [](double deg) { return deg * std::numbers::pi / 180; });
  return all;
}

void check(const CObservationRotatingScan& scan)
{
  if (scan.rowCount == 0 || scan.columnCount == 0 || scan.rangeImage.rows() != scan.rowCount ||
      scan.rangeImage.cols() != scan.columnCount)
  {
    throw Refused("its range image does not have the size it says");
  }
  if (!(scan.rangeResolution > 0) || !std::isfinite(scan.rangeResolution) ||
      !std::isfinite(scan.startAzimuth) || !std::isfinite(scan.azimuthSpan))
  {
    throw Refused("its angles or its range resolution are no numbers");
  }
}

/** All that is the same for every row. */
points::RangeRow rowOf(const CObservationRotatingScan& scan, const Request& request)
{
  points::RangeRow row;
  row.stamp = stampOf(scan);
  row.sensor_label = scan.sensorLabel;
  row.T_base_sensor = sensorPoseOf(scan);
  row.first_bearing_rad = scan.startAzimuth;
  row.step_rad = scan.columnCount > 1 ? scan.azimuthSpan / (scan.columnCount - 1) : 0;
  row.sensor_max_range_m =
      std::isfinite(scan.maxRange) && scan.maxRange > 0 ? static_cast<float>(scan.maxRange) : 0;
  row.limits = request.limits();
  return row;
}

points::Decoded decodeOne(const CObservationRotatingScan& scan, points::RangeRow row, int index)
{
  std::vector<float> range_m(scan.columnCount);
  std::vector<char> valid(scan.columnCount);
  for (int column = 0; column < scan.columnCount; ++column)
  {
    const uint16_t units = scan.rangeImage(index, column);
    range_m[column] = static_cast<float>(units * scan.rangeResolution);
    valid[column] = units != 0 ? 1 : 0;
  }
  row.range_m = range_m;
  row.valid = valid;
  return points::decodeRow(row);
}

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from)
{
  to.insert(to.end(), from.begin(), from.end());
}

void appendRow(points::Decoded& all, const points::Decoded& row, uint16_t ring)
{
  append(all.scan.x, row.scan.x);
  append(all.scan.y, row.scan.y);
  append(all.scan.z, row.scan.z);
  all.scan.ring.resize(all.scan.size(), ring);
  append(all.image.beam, row.image.beam);
  append(all.image.range_m, row.image.range_m);
  append(all.image.azimuth_rad, row.image.azimuth_rad);
  append(all.image.elevation_rad, row.image.elevation_rad);
  all.rejects += row.rejects;
}
}  // namespace

points::Decoded decodeRotatingScan(const Request& request)
{
  const auto& scan = dynamic_cast<const CObservationRotatingScan&>(request.observation);
  check(scan);
  const std::vector<double> elevation_rad = elevations(scan, request.params);
  std::vector<int> lowest_first(elevation_rad.size());
  std::iota(lowest_first.begin(), lowest_first.end(), 0);
  std::stable_sort(
      lowest_first.begin(), lowest_first.end(),
      [&](int a, int b) { return elevation_rad[a] < elevation_rad[b]; });
  points::RangeRow row = rowOf(scan, request);
  points::Decoded all;
  for (size_t ring = 0; ring < lowest_first.size(); ++ring)
  {
    row.elevation_rad = elevation_rad[lowest_first[ring]];
    const points::Decoded one = decodeOne(scan, row, lowest_first[ring]);
    if (ring == 0)
    {
      all = one;
      all.scan.ring.assign(all.scan.size(), 0);
      continue;
    }
    appendRow(all, one, static_cast<uint16_t>(ring));
  }
  all.image.rows = scan.rowCount;
  return all;
}
}  // namespace traverse::observations
