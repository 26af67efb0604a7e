// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "archive_parts.h"

#include "sensor_bits.h"

#include <algorithm>

namespace traverse::traversability_grid
{
namespace
{
constexpr size_t kLongestLabel = 4096;
constexpr size_t kDrivenBytes = 4 + 4 + 6 * 8;

/** Further up or down nothing is driven on. */
constexpr int64_t kHighest_mm = 100'000'000'000;
constexpr int64_t kSteepest = 10'001;  // in DrivenCells::kSlopeUnit

bool isIn(const DrivenCells::Range& range, int64_t most)
{
  return -most <= range.low && range.low <= range.high && range.high <= most;
}
}  // namespace

std::vector<uint32_t> archivedBits(const std::vector<std::string>& sensors)
{
  std::vector<uint32_t> bits;
  bits.reserve(sensors.size());
  for (const std::string& label : sensors)
  {
    bits.push_back(sensorBitOf(static_cast<size_t>(std::count_if(
        sensors.begin(), sensors.end(), [&](const std::string& other) { return other < label; }))));
  }
  return bits;
}

std::string sensorBytes(std::vector<std::string> sensors)
{
  std::sort(sensors.begin(), sensors.end());
  formats::ByteWriter out;
  out.u32(static_cast<uint32_t>(sensors.size()));
  for (const std::string& label : sensors)
  {
    out.str(label);
  }
  return out.take();
}

void readSensors(formats::ByteReader in, std::vector<std::string>& sensors)
{
  const uint32_t count = in.u32();
  if (count > kMostSensors)
  {
    in.fail("more sensors than a map knows apart");
  }
  for (uint32_t i = 0; i < count; ++i)
  {
    sensors.push_back(in.str(kLongestLabel));
    if (i > 0 && !(sensors[i - 1] < sensors[i]))
    {
      in.fail("sensors out of order");
    }
  }
  in.expectEnd();
}

std::string drivenBytes(const DrivenCells& driven)
{
  formats::ByteWriter out;
  out.u64(driven.cells().size());
  for (const auto& [place, stand] : driven.cells())
  {
    out.i32(place.first);
    out.i32(place.second);
    for (const DrivenCells::Range& range : {stand.z_mm, stand.slope_x, stand.slope_y})
    {
      out.i64(range.low);
      out.i64(range.high);
    }
  }
  return out.take();
}

void readDriven(formats::ByteReader in, DrivenCells& driven)
{
  const size_t count = in.count(kDrivenBytes);
  for (size_t i = 0; i < count; ++i)
  {
    const int32_t row = in.i32();
    const int32_t column = in.i32();
    DrivenCells::Stand stand;
    for (DrivenCells::Range* range : {&stand.z_mm, &stand.slope_x, &stand.slope_y})
    {
      range->low = in.i64();
      range->high = in.i64();
    }
    if (!isIn(stand.z_mm, kHighest_mm) || !isIn(stand.slope_x, kSteepest) ||
        !isIn(stand.slope_y, kSteepest))
    {
      in.fail("a driven cell that no poses can make");
    }
    driven.add({row, column}, stand);
  }
  if (driven.cells().size() != count)
  {
    in.fail("a driven cell that is there twice");
  }
  in.expectEnd();
}
}  // namespace traverse::traversability_grid
