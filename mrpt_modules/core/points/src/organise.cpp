// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/points/organise.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace traverse::points
{
namespace
{
struct Spherical
{
  float azimuth_rad, elevation_rad, range_m;
};

std::vector<Spherical> spherical(const Scan& scan)
{
  const Eigen::Isometry3f T_sensor_base = scan.T_base_sensor.inverse().cast<float>();
  std::vector<Spherical> all;
  all.reserve(scan.size());
  for (size_t i = 0; i < scan.size(); ++i)
  {
    const Eigen::Vector3f p = T_sensor_base * Eigen::Vector3f(scan.x[i], scan.y[i], scan.z[i]);
    const float range = p.norm();
    const float elevation = range > 0 ? std::asin(std::clamp(p.z() / range, -1.0F, 1.0F)) : 0.0F;
    all.push_back({std::atan2(p.y(), p.x()), elevation, range});
  }
  return all;
}

int slot(double fraction, int count)
{
  return std::clamp(static_cast<int>(std::floor(fraction * count)), 0, count - 1);
}

RangeImage blank(const Scan& scan, const OrganiseGrid& grid, double lowest, double height)
{
  RangeImage image;
  image.stamp = scan.stamp;
  image.sensor_label = std::string(scan.sensor_label);
  image.T_base_sensor = scan.T_base_sensor;
  image.rows = grid.rows;
  image.columns = grid.columns;
  image.closes = true;
  const size_t cells = static_cast<size_t>(grid.rows) * static_cast<size_t>(grid.columns);
  image.beam.assign(cells, Beam::rejected);
  image.range_m.assign(cells, std::numeric_limits<float>::quiet_NaN());
  image.azimuth_rad.reserve(cells);
  image.elevation_rad.reserve(cells);
  for (int row = 0; row < grid.rows; ++row)
  {
    for (int column = 0; column < grid.columns; ++column)
    {
      const double turn = (column + 0.5) / grid.columns;
      image.azimuth_rad.push_back(static_cast<float>((turn - 0.5) * 2 * std::numbers::pi));
      image.elevation_rad.push_back(static_cast<float>(lowest + (row + 0.5) / grid.rows * height));
    }
  }
  return image;
}
}  // namespace

RangeImage organise(const Scan& scan, const OrganiseGrid& grid)
{
  constexpr int64_t kMaxCells = 1 << 24;
  if (grid.rows < 1 || grid.columns < 1 || int64_t{grid.rows} * grid.columns > kMaxCells)
  {
    throw std::invalid_argument("organise: a grid of 1 to 2^24 cells is needed");
  }
  if (scan.size() == 0)
  {
    return {};
  }
  const std::vector<Spherical> points = spherical(scan);
  const auto [low, high] = std::minmax_element(
      points.begin(), points.end(),
      [](const Spherical& a, const Spherical& b) { return a.elevation_rad < b.elevation_rad; });
  const double height =
      std::max(1e-6, static_cast<double>(high->elevation_rad) - low->elevation_rad);
  RangeImage image = blank(scan, grid, low->elevation_rad, height);
  for (const Spherical& p : points)
  {
    const int row = slot((p.elevation_rad - low->elevation_rad) / height, grid.rows);
    const int column = slot(p.azimuth_rad / (2 * std::numbers::pi) + 0.5, grid.columns);
    const size_t at = image.index(row, column);
    if (image.beam[at] == Beam::hit && image.range_m[at] <= p.range_m)
    {
      continue;
    }
    image.beam[at] = Beam::hit;
    image.range_m[at] = p.range_m;
    image.azimuth_rad[at] = p.azimuth_rad;
    image.elevation_rad[at] = p.elevation_rad;
    image.max_range_m = std::max(image.max_range_m, p.range_m);
  }
  return image;
}
}  // namespace traverse::points
