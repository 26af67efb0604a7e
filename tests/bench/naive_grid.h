// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kitti_cloud.h"

#include <traverse/traversability_grid/traversability_grid.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace traverse::bench
{
using namespace traversability_grid;

using NaiveCell = std::pair<uint32_t, Class>;  // points, class

/** All of a cell's points, as the paper has them; two passes in double. */
inline NaiveCell classifyNaively(
    const std::vector<Eigen::Vector3d>& points, const Classifier& classify)
{
  Features f;
  f.n = points.size();
  const auto n = static_cast<double>(points.size());
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points)
  {
    mean += p / n;
  }
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& p : points)
  {
    const Eigen::Vector3d d = p - mean;
    f.deviation_m = std::max(f.deviation_m, std::abs(d.z()));
    scatter += d * d.transpose();
  }
  f.variance_m2 = scatter(2, 2) / n;
  const double determinant = scatter(0, 0) * scatter(1, 1) - scatter(0, 1) * scatter(0, 1);
  const double trace = scatter(0, 0) + scatter(1, 1);
  f.has_plane = determinant > 1e-9 * trace * trace;
  if (f.has_plane)
  {
    f.slope_x = (scatter(0, 2) * scatter(1, 1) - scatter(1, 2) * scatter(0, 1)) / determinant;
    f.slope_y = (scatter(1, 2) * scatter(0, 0) - scatter(0, 2) * scatter(0, 1)) / determinant;
  }
  return {static_cast<uint32_t>(points.size()), classify(f)};
}

using NaiveMap = std::unordered_map<uint64_t, NaiveCell>;

inline NaiveMap naiveMap(
    const points::ScanBuffer& scan, const Eigen::Isometry3d& T, const Params& params)
{
  const auto near = [&](double p, double robot) {
    return static_cast<int64_t>(std::floor(p / 200)) - static_cast<int64_t>(std::floor(robot * 5));
  };
  std::unordered_map<uint64_t, std::vector<Eigen::Vector3d>> cells;
  for (size_t i = 0; i < scan.size(); ++i)
  {
    const Eigen::Vector3d p = T * Eigen::Vector3d(scan.x[i], scan.y[i], scan.z[i]);
    const Eigen::Vector3d mm(
        std::round(p.x() * 1000), std::round(p.y() * 1000), std::round(p.z() * 1000));
    const int64_t column = near(mm.x(), T.translation().x()) + 375;
    const int64_t row = near(mm.y(), T.translation().y()) + 375;
    if (column >= 0 && column < 750 && row >= 0 && row < 750 &&
        std::abs(p.z() - T.translation().z()) <= 30)
    {
      cells[static_cast<uint64_t>(row * 750 + column)].push_back(mm / 1000);
    }
  }
  const Classifier classify(params);
  NaiveMap map;
  for (const auto& [cell, points] : cells)
  {
    map[cell] = classifyNaively(points, classify);
  }
  return map;
}
}  // namespace traverse::bench
