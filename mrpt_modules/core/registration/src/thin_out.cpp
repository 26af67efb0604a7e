// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "thin_out.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>

namespace traverse::registration
{
namespace
{
constexpr double kVoxelsToThere = 30;
constexpr double kSmallestVoxel_m = 0.05;
constexpr double kLargestVoxel_m = 1;

/** A set of voxels by hash, made for a known number of points at most. */
class VoxelSet
{
 public:
  VoxelSet(size_t most, double voxel_m) :
      keys_(std::bit_ceil(2 * most + 2), kFree), per_m_(1 / voxel_m)
  {
  }

  /** False where a point before lies in the same voxel. */
  bool add(const Eigen::Vector3d& p)
  {
    uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      // 21 bits each: voxels a million edges apart share a key, which no scan reaches.
      const auto index = static_cast<int64_t>(std::floor(p[axis] * per_m_));
      key = (key << 21U) | (static_cast<uint64_t>(index) & 0x1fffffU);
    }
    size_t slot = (key * 0x9e3779b97f4a7c15U >> 20U) & (keys_.size() - 1);
    while (keys_[slot] != kFree && keys_[slot] != key)
    {
      slot = (slot + 1) & (keys_.size() - 1);
    }
    const bool is_new = keys_[slot] == kFree;
    keys_[slot] = key;
    return is_new;
  }

 private:
  static constexpr uint64_t kFree = ~uint64_t{0};
  std::vector<uint64_t> keys_;
  double per_m_;
};

Eigen::Vector3d originOf(const points::Scan& scan)
{
  const Eigen::Vector3d at = scan.T_base_sensor.translation();
  return at.allFinite() ? at : Eigen::Vector3d::Zero();
}
}  // namespace

std::vector<size_t> thinOutIndices(const points::Scan& scan, const Thinning& thinning)
{
  const Eigen::Vector3d origin = originOf(scan);
  const double reach2 = thinning.max_range_m * thinning.max_range_m;
  VoxelSet seen(scan.size(), thinning.voxel_m);
  std::vector<size_t> kept;
  kept.reserve(scan.size() / 4);
  for (size_t i = 0; i < scan.size(); ++i)
  {
    const Eigen::Vector3d p(scan.x[i], scan.y[i], scan.z[i]);
    const bool within = (p - origin).squaredNorm() <= reach2;  // false for NaN
    if (within && seen.add(p))
    {
      kept.push_back(i);
    }
  }
  return kept;
}

std::vector<Eigen::Vector3d> thinOut(const points::Scan& scan, const Thinning& thinning)
{
  const std::vector<size_t> indices = thinOutIndices(scan, thinning);
  std::vector<Eigen::Vector3d> kept;
  kept.reserve(indices.size());
  std::transform(
      indices.begin(), indices.end(), std::back_inserter(kept),
      [&](size_t i) { return Eigen::Vector3d(scan.x[i], scan.y[i], scan.z[i]); });
  return kept;
}

std::vector<Eigen::Vector3d> thinOut(std::span<const Eigen::Vector3d> points, double voxel_m)
{
  VoxelSet seen(points.size(), voxel_m);
  std::vector<Eigen::Vector3d> kept;
  kept.reserve(points.size());
  std::copy_if(
      points.begin(), points.end(), std::back_inserter(kept),
      [&](const Eigen::Vector3d& p) { return seen.add(p); });
  return kept;
}

double voxelFor(const points::Scan& scan, double max_range_m)
{
  const Eigen::Vector3d origin = originOf(scan);
  std::vector<double> ranges_m;
  ranges_m.reserve(scan.size());
  for (size_t i = 0; i < scan.size(); ++i)
  {
    const double r = (Eigen::Vector3d(scan.x[i], scan.y[i], scan.z[i]) - origin).norm();
    if (r <= max_range_m)
    {
      ranges_m.push_back(r);
    }
  }
  if (ranges_m.empty())
  {
    return 1;
  }
  const auto at = ranges_m.begin() + static_cast<std::ptrdiff_t>(ranges_m.size() * 9 / 10);
  std::nth_element(ranges_m.begin(), at, ranges_m.end());
  return std::clamp(*at / kVoxelsToThere, kSmallestVoxel_m, kLargestVoxel_m);
}
}  // namespace traverse::registration
