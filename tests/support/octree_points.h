// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/formats/octree_file.h>
#include <traverse/formats/point_octree.h>

#include <array>
#include <random>
#include <set>
#include <tuple>
#include <vector>

// Points for octrees, and their leaves in an order that can be compared.
namespace traverse::testing
{
using Point = std::array<double, 3>;
using Leaf = std::tuple<uint16_t, uint16_t, uint16_t>;

inline points::ScanBuffer scanOf(const std::vector<Point>& all)
{
  points::ScanBuffer scan;
  for (const Point& p : all)
  {
    scan.x.push_back(static_cast<float>(p[0]));
    scan.y.push_back(static_cast<float>(p[1]));
    scan.z.push_back(static_cast<float>(p[2]));
  }
  return scan;
}

inline std::vector<Point> randomPoints(std::mt19937& random, size_t n, double half_m = 3)
{
  std::uniform_real_distribution<double> along(-half_m, half_m);
  std::vector<Point> all;
  for (size_t i = 0; i < n; ++i)
  {
    all.push_back({along(random), along(random), along(random) / 4});
  }
  return all;
}

inline formats::PointOctree octreeOf(const std::vector<Point>& all, double resolution_m = 0.1)
{
  formats::PointOctree octree({resolution_m, 100});
  octree.insert(scanOf(all).view(), Eigen::Isometry3d::Identity());
  return octree;
}

inline std::set<Leaf> leavesOf(std::string_view bytes)
{
  std::set<Leaf> leaves;
  for (const formats::OctreeKey& k : formats::readOctree(bytes).occupied)
  {
    leaves.emplace(k.x, k.y, k.z);
  }
  return leaves;
}
}  // namespace traverse::testing
