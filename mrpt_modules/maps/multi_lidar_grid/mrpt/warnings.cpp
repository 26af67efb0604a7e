// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a user must know of the sensors.
#include <traverse/maps/CWrappableMultiLidarGrid.h>
#include <traverse/options/untrusted_text.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace traverse::maps
{
namespace
{
using multi_lidar_grid::Health;
using multi_lidar_grid::Sensor;

std::string meaningOf(Health health)
{
  switch (health)
  {
    case Health::late:
      return "its next cloud is overdue";
    case Health::stale:
    case Health::dead:
      return "its latest cloud no longer counts";
    case Health::stuck:
      return "it sends the same cloud again and again";
    case Health::ok:
      break;
  }
  return "";
}

/** Labels of an option that no sensor has, of which clouds came: misspelt, or the log lacks it. */
void warnOfAbsent(
    std::string_view key,
    std::string_view labels,
    const multi_lidar_grid::Sensors& sensors,
    std::vector<std::string>& texts)
{
  std::string came;
  for (const Sensor& sensor : sensors.all())
  {
    came += (came.empty() ? "" : ", ") + fmt::format("'{}'", options::printable(sensor.label));
  }
  for (const std::string_view label : multi_lidar_grid::labelsIn(labels))
  {
    const auto has_it = [&](const Sensor& sensor) { return sensor.label == label; };
    if (!came.empty() && std::none_of(sensors.all().begin(), sensors.all().end(), has_it))
    {
      texts.push_back(fmt::format(
          "{} names '{}', of which no cloud came; clouds came of {}", key,
          options::printable(label), came));
    }
  }
}
}  // namespace

std::vector<std::string> CWrappableMultiLidarGrid::warnings() const
{
  std::vector<std::string> texts;
  warnOfAbsent("sensor_labels", made_with_.sensor_labels, state_.sensors, texts);
  warnOfAbsent("clearing_labels", made_with_.clearing_labels, state_.sensors, texts);
  for (const Sensor& sensor : state_.sensors.all())
  {
    const std::string name = fmt::format("sensor '{}'", options::printable(sensor.label));
    const Health health = multi_lidar_grid::healthOf(sensor, state_.now, made_with_);
    if (health != Health::ok)
    {
      texts.push_back(fmt::format(
          "{} is {}: {}, its newest is {:.2f} s old", name, multi_lidar_grid::nameOf(health),
          meaningOf(health), poses::secondsBetween(sensor.newest, state_.now)));
    }
    const bool is_given = multi_lidar_grid::sensorParams(made_with_, sensor.label).is_offset_given;
    constexpr double kNoticed_s = 0.01;  // half a step of those that are tried
    if (std::abs(sensor.clock_offset_s) >= kNoticed_s && !is_given)
    {
      texts.push_back(fmt::format(
          "{}: its clock seems off, {:+.3f} s were added to its stamps (estimate_clock_offsets; "
          "give sensor_clock_offsets_s where it is known)",
          name, sensor.clock_offset_s));
    }
    if (sensor.refused > 0)
    {
      texts.push_back(fmt::format(
          "{}: {} clouds were refused: later than order_window_s = {} s, or always the same while "
          "the vehicle moved",
          name, sensor.refused, made_with_.order_window_s));
    }
  }
  return texts;
}
}  // namespace traverse::maps
