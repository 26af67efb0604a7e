// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_table.h"

#include <traverse/formats/bytes.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <initializer_list>
#include <limits>

namespace traverse::formats
{
namespace
{
const CloudField* find(const CloudTable& table, std::initializer_list<std::string_view> names)
{
  for (const std::string_view name : names)
  {
    for (const CloudField& field : table.fields)
    {
      if (field.name == name)
      {
        return &field;
      }
    }
  }
  return nullptr;
}

/** Reads a field into a channel; `convert` takes the number. */
template <class T, class F>
void fill(const CloudTable& table, const CloudField* field, std::vector<T>& channel, F&& convert)
{
  if (field == nullptr)
  {
    return;
  }
  channel.reserve(table.points);
  for (size_t i = 0; i < table.points; ++i)
  {
    channel.push_back(convert(table.number(*field, i)));
  }
}

void takePositions(const CloudTable& table, CloudFile& cloud)
{
  const auto axis = [&](std::string_view name, std::vector<double>& to)
  {
    const CloudField* field = find(table, {name});
    if (field == nullptr)
    {
      throw FormatError(fmt::format("has no field {}", name));
    }
    fill(table, field, to, [](double v) { return v; });
  };
  axis("x", cloud.x);
  axis("y", cloud.y);
  axis("z", cloud.z);
}

/** 0..255; fractions are of 1. */
uint32_t level(const CloudField& field, double value)
{
  const double scaled = field.kind == NumberKind::floating ? value * 255 : value;
  const bool wide = field.kind != NumberKind::floating && field.size > 1;
  const double byte = wide && scaled > 255 ? scaled / 257 : scaled;
  return std::isfinite(byte) ? static_cast<uint32_t>(std::lround(std::clamp(byte, 0.0, 255.0))) : 0;
}

void takeColours(const CloudTable& table, CloudFile& cloud)
{
  const CloudField* packed = find(table, {"rgb", "rgba"});
  if (packed != nullptr && packed->size == 4)
  {
    cloud.rgb.reserve(table.points);
    for (size_t i = 0; i < table.points; ++i)
    {
      cloud.rgb.push_back(table.bits(*packed, i) & 0xFFFFFFU);
    }
    return;
  }
  const CloudField* red = find(table, {"red", "r", "diffuse_red"});
  const CloudField* green = find(table, {"green", "g", "diffuse_green"});
  const CloudField* blue = find(table, {"blue", "b", "diffuse_blue"});
  if (red == nullptr || green == nullptr || blue == nullptr)
  {
    return;
  }
  cloud.rgb.reserve(table.points);
  for (size_t i = 0; i < table.points; ++i)
  {
    cloud.rgb.push_back(
        level(*red, table.number(*red, i)) << 16U | level(*green, table.number(*green, i)) << 8U |
        level(*blue, table.number(*blue, i)));
  }
}
}  // namespace

CloudFile cloudOf(const CloudTable& table)
{
  CloudFile cloud;
  takePositions(table, cloud);
  cloud.width = table.points;
  fill(
      table,
      find(
          table, {"intensity", "i", "reflectivity", "reflectance", "remission", "scalar_intensity",
                  "scalar_reflectance"}),
      cloud.intensity, [](double v) { return static_cast<float>(v); });
  fill(
      table, find(table, {"ring", "channel", "laser_number", "laser_id", "line", "row"}),
      cloud.ring,
      [](double v) { return v >= 0 && v <= 65535 ? static_cast<uint16_t>(v) : uint16_t{65535}; });
  takeColours(table, cloud);
  const CloudField* time = find(
      table, {"timestamp", "time", "t", "stamp", "time_stamp", "offset_ns", "offset_time",
              "time_offset", "timestamp_ns", "gps_time", "scalar_time"});
  if (time != nullptr)
  {
    takeTimes(table, *time, cloud);
  }
  return cloud;
}
}  // namespace traverse::formats
