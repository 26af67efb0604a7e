// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "velodyne_capture.h"

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace traverse::testing
{
/** What tests/oracle/velodyne_cloud/record.js wrote. */
struct RecordedCloud
{
  struct Laser
  {
    size_t laser = 0;
    size_t count = 0;
    double distance_m = 0;
    double z_m = 0;
    double intensity = 0;
  };

  struct Point
  {
    size_t index = 0;
    double x_m = 0;
    double y_m = 0;
    double z_m = 0;
    double intensity = 0;
    size_t laser = 0;
    double azimuth_hundredths = 0;
    double time_ns = 0;
  };

  std::vector<Laser> lasers;
  std::vector<Point> points;

  size_t count() const
  {
    size_t sum = 0;
    for (const Laser& laser : lasers)
    {
      sum += laser.count;
    }
    return sum;
  }
};

inline RecordedCloud recordedCloud(const std::filesystem::path& file)
{
  const std::vector<uint8_t> bytes = bytesOf(file);
  std::istringstream lines(std::string(bytes.begin(), bytes.end()));
  RecordedCloud cloud;
  for (std::string line; std::getline(lines, line);)
  {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream row(line);
    std::vector<double> v;
    for (double value = 0; row >> value;)
    {
      v.push_back(value);
    }
    if (v.size() == 5)
    {
      cloud.lasers.push_back(
          {static_cast<size_t>(v[0]), static_cast<size_t>(v[1]), v[2], v[3], v[4]});
    }
    else if (v.size() == 8)
    {
      cloud.points.push_back(
          {static_cast<size_t>(v[0]), v[1], v[2], v[3], v[4], static_cast<size_t>(v[5]), v[6],
           v[7]});
    }
  }
  return cloud;
}
}  // namespace traverse::testing
