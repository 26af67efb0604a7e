// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/multi_lidar_grid/params.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace traverse::multi_lidar_grid
{
namespace
{
constexpr double kMostCells = 4096;

void checkLength(std::string_view key, const std::vector<double>& values, size_t labels)
{
  if (!values.empty() && values.size() != labels)
  {
    throw options::OptionError(
        key, options::format(values), "empty, or one for each of sensor_labels");
  }
}

void checkLists(const Params& p)
{
  std::vector<std::string_view> each = labelsIn(p.sensor_labels);
  const size_t labels = each.size();
  std::sort(each.begin(), each.end());
  if (std::adjacent_find(each.begin(), each.end()) != each.end())
  {
    throw options::OptionError("sensor_labels", p.sensor_labels, "each label once");
  }
  checkLength("sensor_ranges_m", p.sensor_ranges_m, labels);
  checkLength("sensor_first_azimuths_deg", p.sensor_first_azimuths_deg, labels);
  checkLength("sensor_last_azimuths_deg", p.sensor_last_azimuths_deg, labels);
  checkLength("sensor_timeouts_s", p.sensor_timeouts_s, labels);
  checkLength("sensor_clock_offsets_s", p.sensor_clock_offsets_s, labels);
  if (p.sensor_first_azimuths_deg.size() != p.sensor_last_azimuths_deg.size())
  {
    throw options::OptionError(
        "sensor_last_azimuths_deg", options::format(p.sensor_last_azimuths_deg),
        "as many as sensor_first_azimuths_deg");
  }
  for (size_t i = 0; i < p.sensor_first_azimuths_deg.size(); ++i)
  {
    if (p.sensor_last_azimuths_deg[i] <= p.sensor_first_azimuths_deg[i])
    {
      throw options::OptionError(
          "sensor_last_azimuths_deg", options::format(p.sensor_last_azimuths_deg),
          "each greater than its first azimuth");
    }
  }
}

bool contains(const std::vector<std::string_view>& list, std::string_view label)
{
  return std::find(list.begin(), list.end(), label) != list.end();
}
}  // namespace

std::vector<std::string_view> labelsIn(std::string_view list)
{
  std::vector<std::string_view> found;
  for (size_t at = list.find_first_not_of(' '); at != std::string_view::npos;
       at = list.find_first_not_of(' ', at))
  {
    const size_t end = std::min(list.find(' ', at), list.size());
    found.push_back(list.substr(at, end - at));
    at = end;
  }
  return found;
}

void check(const Params& params, const geometry::Vehicle& vehicle)
{
  options::check(params);
  checkLists(params);
  if (params.window_m / params.cell_size_m > kMostCells)
  {
    throw options::OptionError(
        "window_m", options::format(params.window_m), "at most 4096 cells of cell_size_m");
  }
  if (vehicle.height_m <= params.obstacle_height_m)
  {
    throw options::OptionError(
        "obstacle_height_m", options::format(params.obstacle_height_m),
        "less than the vehicle's height_m");
  }
}

SensorParams sensorParams(const Params& params, std::string_view label)
{
  SensorParams sensor;
  sensor.range_m = params.max_range_m;
  sensor.timeout_s = params.timeout_s;
  sensor.clears_without_return = contains(labelsIn(params.clearing_labels), label);
  const std::vector<std::string_view> labels = labelsIn(params.sensor_labels);
  const auto found = std::find(labels.begin(), labels.end(), label);
  if (found == labels.end())
  {
    return sensor;
  }
  const auto i = static_cast<size_t>(found - labels.begin());
  auto take = [i](const std::vector<double>& list, double& value)
  {
    value = list.empty() ? value : list[i];
    return !list.empty();
  };
  take(params.sensor_ranges_m, sensor.range_m);
  take(params.sensor_first_azimuths_deg, sensor.first_azimuth_deg);
  take(params.sensor_last_azimuths_deg, sensor.last_azimuth_deg);
  take(params.sensor_timeouts_s, sensor.timeout_s);
  sensor.is_offset_given = take(params.sensor_clock_offsets_s, sensor.clock_offset_s);
  return sensor;
}

double hardBuffer_m(const Params& params, const geometry::Vehicle& vehicle)
{
  if (params.hard_buffer_m > 0)
  {
    return params.hard_buffer_m;
  }
  double largest_m = 0;
  const auto& xs = vehicle.footprint_xs_m;
  const auto& ys = vehicle.footprint_ys_m;
  for (size_t i = 0; i < std::min(xs.size(), ys.size()); ++i)
  {
    for (size_t j = 0; j < i; ++j)
    {
      largest_m = std::max(largest_m, std::hypot(xs[i] - xs[j], ys[i] - ys[j]));
    }
  }
  return largest_m / 2;
}
}  // namespace traverse::multi_lidar_grid
