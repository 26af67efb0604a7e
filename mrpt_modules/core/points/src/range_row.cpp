// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "grid_trig.h"

#include <traverse/points/range_row.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>

namespace traverse::points
{
namespace
{
/** What one value says. */
struct Reading
{
  Beam beam = Beam::rejected;
  std::optional<Reject> reject;
};

Reading read(const RangeRow& row, size_t i)
{
  const float r = row.range_m[i];
  if (!std::isfinite(r))
  {
    return {Beam::rejected, Reject::nonfinite};
  }
  const bool out_of_reach = row.sensor_max_range_m > 0 && r >= row.sensor_max_range_m;
  const bool valid = row.valid.empty() || row.valid[i] != 0;
  if (out_of_reach || (!valid && r == 0))
  {
    return {Beam::no_return, Reject::no_return};
  }
  if (!valid)
  {
    return {Beam::rejected, Reject::flagged};
  }
  if (r <= 0 || r < row.limits.min_m)
  {
    return {Beam::rejected, Reject::below_range};
  }
  if (r > row.limits.max_m)
  {
    return {Beam::no_return, Reject::beyond_range};
  }
  return {Beam::hit, std::nullopt};
}

void check(const RangeRow& row)
{
  if (!row.valid.empty() && row.valid.size() != row.range_m.size())
  {
    throw std::invalid_argument("a scan row has flags of another length than its ranges");
  }
  if (!std::isfinite(row.first_bearing_rad) || !std::isfinite(row.step_rad) ||
      !std::isfinite(row.elevation_rad))
  {
    throw std::invalid_argument("a scan row has no finite bearings");
  }
}

RangeImage emptyImage(const RangeRow& row)
{
  RangeImage image;
  image.stamp = row.stamp;
  image.sensor_label = row.sensor_label;
  image.T_base_sensor = row.T_base_sensor;
  image.rows = 1;
  image.columns = static_cast<int>(row.range_m.size());
  const double turn = std::abs(row.step_rad) * image.columns;
  image.closes = turn > 2 * std::numbers::pi - 0.5 * std::abs(row.step_rad);
  image.max_range_m = row.sensor_max_range_m > 0
                          ? std::min(row.sensor_max_range_m, row.limits.max_m)
                          : row.limits.max_m;
  const size_t n = row.range_m.size();
  image.beam.reserve(n);
  image.range_m.reserve(n);
  image.azimuth_rad.reserve(n);
  image.elevation_rad.assign(n, static_cast<float>(row.elevation_rad));
  return image;
}
}  // namespace

Decoded decodeRow(const RangeRow& row)
{
  check(row);
  Decoded out;
  out.scan.stamp = row.stamp;
  out.scan.sensor_label = row.sensor_label;
  out.scan.T_base_sensor = row.T_base_sensor;
  if (row.range_m.empty())
  {
    return out;
  }
  out.image = emptyImage(row);
  const size_t n = row.range_m.size();
  for (size_t column = 0; column < n; ++column)
  {
    const size_t i = row.step_rad < 0 ? n - 1 - column : column;
    const double bearing = row.first_bearing_rad + row.step_rad * static_cast<double>(i);
    const Reading reading = read(row, i);
    const bool hit = reading.beam == Beam::hit;
    out.image.beam.push_back(reading.beam);
    out.image.azimuth_rad.push_back(static_cast<float>(bearing));
    out.image.range_m.push_back(hit ? row.range_m[i] : std::numeric_limits<float>::quiet_NaN());
    if (!hit)
    {
      out.rejects.add(*reading.reject);
      continue;
    }
    const Eigen::Vector3d p = row.T_base_sensor * (beamDirection(bearing, row.elevation_rad) *
                                                   static_cast<double>(row.range_m[i]));
    out.scan.x.push_back(static_cast<float>(p.x()));
    out.scan.y.push_back(static_cast<float>(p.y()));
    out.scan.z.push_back(static_cast<float>(p.z()));
  }
  return out;
}
}  // namespace traverse::points
