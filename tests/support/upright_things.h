// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "labelled_clouds.h"
#include "path_errors.h"

#include <cmath>
#include <cstdio>
#include <map>
#include <utility>

// Trunks, poles and signs as a judge of poses that needs no reference.
namespace traverse::testing
{
/** Where they are seen from above, within 40 m, above the ground; vehicle frame of the scan. */
inline std::vector<Eigen::Vector3d> uprightThings(const std::filesystem::path& folder, size_t frame)
{
  std::array<char, 16> name{};
  std::snprintf(name.data(), name.size(), "%06zu", frame);
  const LabelledCloud cloud = readLabelled(
      Layout::kitti, folder / "velodyne" / (std::string(name.data()) + ".bin.gz"),
      folder / "labels" / (std::string(name.data()) + ".label.gz"));
  std::vector<Eigen::Vector3d> things;
  for (size_t i = 0; i < cloud.scan.size(); ++i)
  {
    const Eigen::Vector3d p(cloud.scan.x[i], cloud.scan.y[i], cloud.scan.z[i]);
    const uint32_t label = cloud.labels[i] & 0xffffU;
    const bool upright = label == 71 || label == 80 || label == 81;
    if (upright && p.head<2>().norm() < 40 && p.z() > -1.2)
    {
      things.push_back(p);
    }
  }
  return things;
}

/** Mean distance, seen from above, from those of each later scan to the nearest of the first one;
 * what has none within 0.5 m counts as 0.5 m. 0.02 to 0.03 m is the sensor's noise and the things'
 * own width. */
inline double thingsApart_m(const std::filesystem::path& folder, const Path& path)
{
  constexpr double kMost_m = 0.5;
  const auto cell_of = [](const Eigen::Vector3d& p)
  { return std::pair(std::floor(p.x() / kMost_m), std::floor(p.y() / kMost_m)); };
  std::map<std::pair<double, double>, std::vector<Eigen::Vector3d>> first;
  for (const Eigen::Vector3d& p : uprightThings(folder, 0))
  {
    first[cell_of(p)].push_back(p);
  }
  const auto nearest = [&](const Eigen::Vector3d& p)
  {
    double least_m = kMost_m;
    const auto [x, y] = cell_of(p);
    for (int i = 0; i < 9; ++i)
    {
      const auto cell = first.find({x + i % 3 - 1, y + i / 3 - 1});
      for (size_t k = 0; cell != first.end() && k < cell->second.size(); ++k)
      {
        least_m = std::min(least_m, (cell->second[k] - p).head<2>().norm());
      }
    }
    return least_m;
  };
  double sum_m = 0;
  double n = 0;
  for (size_t frame = 1; frame < path.size(); ++frame)
  {
    const Eigen::Isometry3d T = path[0].inverse() * path[frame];
    for (const Eigen::Vector3d& p : uprightThings(folder, frame))
    {
      sum_m += nearest(T * p);
      n += 1;
    }
  }
  return n > 0 ? sum_m / n : std::nan("");
}
}  // namespace traverse::testing
