// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/traversability_grid/traversability_grid.h>

#include <random>
#include <string>
#include <vector>

// Scenes drawn as text, seen from above: one character a cell of 0.2 m, the top row has the largest
// y, the lower left cell is (0, 0).
namespace traverse::testing
{
using Picture = std::vector<std::string>;

inline Eigen::Isometry3d atPlace(double x, double y, double z = 0, double yaw_rad = 0)
{
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  T.translation() = Eigen::Vector3d(x, y, z);
  return T;
}

inline void addPoint(points::ScanBuffer& scan, double x, double y, double z)
{
  scan.x.push_back(static_cast<float>(x));
  scan.y.push_back(static_cast<float>(y));
  scan.z.push_back(static_cast<float>(z));
}

/** Points of one cell whose smallest corner is (x, y): 5 x 5 of the ground, or what stands there.
 *
 *     .  level ground                    s  a step of 6 cm        l  a step of 20 cm
 *     #  a wall 2 m high along y         f  a fence of 0.36 m: evenly over its height
 *     g  grass of 0.36 m: mostly low     b  ground under a branch at 2.4 m
 *     t  ground under a table at 0.8 m   1  two points only       (blank)  nothing */
inline void drawCell(points::ScanBuffer& scan, char what, double x, double y)
{
  for (int k = 0; k < 25; ++k)
  {
    const int row = k / 5;
    const double u = 0.02 + 0.04 * (k - 5 * row);
    const double v = 0.02 + 0.04 * row;
    const double share = (k + 0.5) / 25;
    switch (what)
    {
      case '.':
      case 'b':
      case 't':
        addPoint(scan, x + u, y + v, 0);
        break;
      case 's':
        addPoint(scan, x + u, y + v, u > 0.1 ? 0.06 : 0);
        break;
      case 'l':
        addPoint(scan, x + u, y + v, u > 0.1 ? 0.20 : 0);
        break;
      case '#':
        addPoint(scan, x + 0.1, y + v, 2 * share);
        break;
      case 'f':
        addPoint(scan, x + u, y + v, 0.36 * ((7 * k + 3) % 25) / 24.0);
        break;
      case 'g':
        addPoint(scan, x + u, y + v, 0.36 * std::pow(((7 * k + 3) % 25) / 24.0, 6));
        break;
      default:
        break;
    }
    if (what == 'b' || what == 't')
    {
      addPoint(scan, x + u, y + v, what == 'b' ? 2.4 : 0.8);
    }
  }
  if (what == '1')
  {
    addPoint(scan, x + 0.1, y + 0.1, 0);
    addPoint(scan, x + 0.05, y + 0.1, 0);
  }
}

inline points::ScanBuffer draw(const Picture& picture)
{
  points::ScanBuffer scan;
  scan.stamp = 1'600'000'000'000'000'000;
  for (size_t row = 0; row < picture.size(); ++row)
  {
    const double y = 0.2 * static_cast<double>(picture.size() - 1 - row);
    for (size_t column = 0; column < picture[row].size(); ++column)
    {
      drawCell(scan, picture[row][column], 0.2 * static_cast<double>(column), y);
    }
  }
  return scan;
}

/** The classes as a picture of the same kind: digits, blank for undefined. */
inline Picture classes(const layers::LayerSet& set)
{
  const auto& codes = std::get<std::vector<uint8_t>>(set.find("traversability_class")->data);
  Picture picture;
  const auto width = static_cast<size_t>(set.extent.width());
  for (auto row = static_cast<size_t>(set.extent.height()); row-- > 0;)
  {
    std::string line;
    for (size_t column = 0; column < width; ++column)
    {
      const uint8_t code = codes[row * width + column];
      line += code == 0 ? ' ' : static_cast<char>('0' + code);
    }
    picture.push_back(line);
  }
  return picture;
}

/** Any points within a box around a robot at the origin of the vehicle frame, finite. */
inline points::ScanBuffer randomScan(std::mt19937& random, size_t n, double half_m = 4)
{
  std::uniform_real_distribution<double> xy(-half_m, half_m);
  std::exponential_distribution<double> up(1.5);
  points::ScanBuffer scan;
  scan.stamp = 1'600'000'000'000'000'000 + static_cast<int64_t>(random()) * 1000;
  for (size_t i = 0; i < n; ++i)
  {
    addPoint(scan, xy(random), xy(random), up(random));
  }
  return scan;
}
}  // namespace traverse::testing
