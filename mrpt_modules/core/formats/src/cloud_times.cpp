// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_table.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace traverse::formats
{
namespace
{
constexpr double kNsPerSecond = 1e9;
constexpr double kFirstClock = 1e8;                 // 1973 in seconds; longer than any sweep
constexpr int64_t kLongest_ns = 3'600'000'000'000;  // of one cloud

/** A beam without an echo often has no time either. */
bool isReturn(const CloudFile& cloud, size_t i)
{
  return std::isfinite(cloud.x[i]) && std::isfinite(cloud.y[i]) && std::isfinite(cloud.z[i]) &&
         (cloud.x[i] != 0 || cloud.y[i] != 0 || cloud.z[i] != 0);
}

/** Nanoseconds of one count of a clock, by how large its numbers are now. */
double clockUnit_ns(double value)
{
  if (value >= 1e17)
  {
    return 1;
  }
  if (value >= 1e14)
  {
    return 1e3;
  }
  return value >= 1e11 ? 1e6 : kNsPerSecond;
}

struct Unit
{
  bool clock = false;
  double ns = 1;
};

Unit unitOf(const CloudTable& table, const CloudField& field, const CloudFile& cloud)
{
  double largest = 0;
  for (size_t i = 0; i < table.points; ++i)
  {
    const double value = std::abs(table.number(field, i));
    largest = isReturn(cloud, i) && value > largest ? value : largest;
  }
  const bool integers = field.kind != NumberKind::floating;
  const bool offsets = field.name.find("offset") != std::string::npos || field.name == "t";
  // Offsets in nanoseconds pass 1e8 within a turn; a clock's that look like them would be of 1973.
  const bool clock =
      largest >= (integers || offsets ? 1e9 : kFirstClock) && !(offsets && largest < 1e12);
  if (clock)
  {
    return {true, clockUnit_ns(largest)};
  }
  return {false, integers || field.name.find("_ns") != std::string::npos ? 1 : kNsPerSecond};
}

/** Of a point, in nanoseconds; 0 for what is no time. */
int64_t nanoseconds(const CloudTable& table, const CloudField& field, const Unit& unit, size_t i)
{
  if (unit.ns == 1 && field.kind != NumberKind::floating)
  {
    return table.integer(field, i);
  }
  const double value = table.number(field, i);
  if (!(std::abs(value) * unit.ns < 9e18))
  {
    return 0;
  }
  // Whole counts apart from fractions: the product has no room for both.
  const double whole = std::floor(value);
  return static_cast<int64_t>(whole) * static_cast<int64_t>(unit.ns) +
         std::llround((value - whole) * unit.ns);
}
}  // namespace

void takeTimes(const CloudTable& table, const CloudField& field, CloudFile& cloud)
{
  const Unit unit = unitOf(table, field, cloud);
  std::vector<int64_t> times_ns;
  times_ns.reserve(table.points);
  int64_t first = std::numeric_limits<int64_t>::max();
  int64_t last = std::numeric_limits<int64_t>::min();
  for (size_t i = 0; i < table.points; ++i)
  {
    times_ns.push_back(nanoseconds(table, field, unit, i));
    if (isReturn(cloud, i))
    {
      first = std::min(first, times_ns.back());
      last = std::max(last, times_ns.back());
    }
  }
  // As unsigned numbers: a hostile first and last may be further apart than 63 bits.
  const auto span = static_cast<uint64_t>(last) - static_cast<uint64_t>(first);
  if (first > last || span > static_cast<uint64_t>(kLongest_ns))
  {
    cloud.note = first > last ? "" : "its field '" + field.name.substr(0, 40) + "' is no time";
    return;
  }
  const int64_t zero = unit.clock ? first : 0;
  if (!unit.clock && (first < -kLongest_ns || last > kLongest_ns))
  {
    cloud.note = "its field '" + field.name.substr(0, 40) + "' is no time";
    return;
  }
  cloud.time_s.reserve(table.points);
  for (size_t i = 0; i < table.points; ++i)
  {
    const double ns = isReturn(cloud, i) ? static_cast<double>(times_ns[i] - zero) : 0.0;
    cloud.time_s.push_back(static_cast<float>(ns / kNsPerSecond));
  }
  if (unit.clock)
  {
    cloud.stamp_ns = first;
  }
}
}  // namespace traverse::formats
