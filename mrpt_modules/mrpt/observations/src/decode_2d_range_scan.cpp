// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "decoders.h"

#include <traverse/points/range_row.h>

#include <mrpt/obs/CObservation2DRangeScan.h>

#include <cmath>
#include <vector>

namespace traverse::observations
{
points::Decoded decode2DRangeScan(const Request& request)
{
  const auto& scan = dynamic_cast<const mrpt::obs::CObservation2DRangeScan&>(request.observation);
  constexpr size_t kMostBeams = 1U << 20U;
  const size_t n = scan.getScanSize();
  if (n > kMostBeams)
  {
    throw Refused("it has an absurd number of beams");
  }
  if (scan.deltaPitch != 0)
  {
    throw Refused("its scanner tilts during a row (deltaPitch), which is not supported");
  }
  std::vector<char> valid(n);
  for (size_t i = 0; i < n; ++i)
  {
    valid[i] = scan.getScanRangeValidity(i) ? 1 : 0;
  }
  points::RangeRow row;
  row.stamp = stampOf(scan);
  row.sensor_label = scan.sensorLabel;
  row.T_base_sensor = sensorPoseOf(scan);
  row.range_m = n > 0 ? std::span(&scan.getScanRange(0), n) : std::span<const float>();
  row.valid = valid;
  const double turn = scan.rightToLeft ? scan.aperture : -static_cast<double>(scan.aperture);
  row.first_bearing_rad = n > 1 ? -turn / 2 : 0;
  row.step_rad = n > 1 ? turn / static_cast<double>(n - 1) : 0;
  row.sensor_max_range_m = std::isfinite(scan.maxRange) ? scan.maxRange : 0;
  row.limits = request.limits();
  return points::decodeRow(row);
}
}  // namespace traverse::observations
