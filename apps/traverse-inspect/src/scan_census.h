// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/points/decoded.h>

#include <cstdint>
#include <map>
#include <string>

namespace traverse::app
{
/** What the scans of one sensor were like. */
struct ScanSensor
{
  uint64_t scans = 0;
  uint64_t points = 0;
  uint64_t empty = 0;  //!< scans without any point
  points::RejectCounts rejects;
  double nearest_m = 0;  //!< of the first cloud's points, from the sensor
  double median_m = 0;
  double farthest_m = 0;
  points::Decoded first;  //!< the first scan with points
};

/** More are no robot's; those of further labels are left out. */
inline constexpr size_t kMostScanSensors = 256;

/** By label, as the log has it. */
using ScanCensus = std::map<std::string, ScanSensor>;

void addTo(ScanCensus& census, points::Decoded decoded);
}  // namespace traverse::app
