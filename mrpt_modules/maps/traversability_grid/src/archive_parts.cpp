// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "archive_parts.h"

#include <algorithm>

namespace traverse::traversability_grid
{
namespace
{
constexpr size_t kMostLabels = 31;
constexpr size_t kLongestLabel = 4096;
constexpr size_t kDrivenBytes = 4 + 4 + 4 * 8;

/** Higher than this nothing is driven on; times DrivenCells::kMostStands it still fits. */
constexpr int64_t kHighest_mm = 100'000'000'000;
constexpr int64_t kMostSlope = 10'001;
}  // namespace

SensorOrder::SensorOrder(const std::vector<std::string>& sensors)
{
  for (const std::string& label : sensors)
  {
    place_.push_back(static_cast<size_t>(std::count_if(
        sensors.begin(), sensors.end(), [&](const std::string& other) { return other < label; })));
  }
}

uint32_t SensorOrder::archived(uint32_t bits) const
{
  constexpr uint32_t kOthers = uint32_t{1} << kMostLabels;
  uint32_t out = bits & kOthers;
  for (size_t i = 0; i < place_.size(); ++i)
  {
    out |= ((bits >> i) & 1U) << place_[i];
  }
  return out;
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
  if (count > kMostLabels)
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
  for (const auto& [place, sums] : driven.cells())
  {
    out.i32(place.first);
    out.i32(place.second);
    out.u64(sums.n);
    out.i64(sums.z_mm);
    out.i64(sums.slope_x);
    out.i64(sums.slope_y);
  }
  return out.take();
}

void readDriven(formats::ByteReader in, DrivenCells& driven)
{
  const size_t count = in.count(kDrivenBytes);
  const auto is_possible = [](const DrivenCells::Sums& s)
  {
    const auto n = static_cast<int64_t>(s.n);
    const auto within = [n](int64_t sum, int64_t most)
    { return sum >= -most * n && sum <= most * n; };
    return s.n > 0 && s.n <= DrivenCells::kMostStands && within(s.z_mm, kHighest_mm) &&
           within(s.slope_x, kMostSlope) && within(s.slope_y, kMostSlope);
  };
  for (size_t i = 0; i < count; ++i)
  {
    const int32_t row = in.i32();
    const int32_t column = in.i32();
    DrivenCells::Sums sums;
    sums.n = in.u64();
    sums.z_mm = in.i64();
    sums.slope_x = in.i64();
    sums.slope_y = in.i64();
    if (!is_possible(sums) || !driven.cells().emplace(std::pair(row, column), sums).second)
    {
      in.fail("a driven cell that no poses can make");
    }
  }
  in.expectEnd();
}
}  // namespace traverse::traversability_grid
