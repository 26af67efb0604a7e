// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace traverse::registration
{
/** The plane through the map around one of its points. */
struct Surface
{
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();  //!< of the points around, map frame, m
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double weight = 0;     //!< square of the flatness: 0 (no plane, or too few points) .. 1 (plane)
  double looseness = 0;  //!< square of 1 - flatness; 0 where there are too few points
};

/** Points of the map around the vehicle, in voxels of at most kMostPoints each (Vizzo et al. 2023,
 * III-D), with the surface around each of them on demand. Memory is bounded by kMostVoxels. */
class LocalMap
{
 public:
  static constexpr size_t kMostPoints = 20;
  static constexpr size_t kMostVoxels = 400'000;

  /** Throws std::invalid_argument unless voxel_m is finite and positive. */
  explicit LocalMap(double voxel_m);

  /** Adds points of the map frame; those that a full voxel or a nearer neighbour than the spacing
   * of a full voxel stands for are left out, and so are those that are not finite. */
  void add(std::span<const Eigen::Vector3d> points);

  /** Drops voxels further than reach_m from `centre`. */
  void forgetBeyond(const Eigen::Vector3d& centre, double reach_m);

  /** The surface at the map's nearest point to `p` of those nearer than reach_m in the voxel of `p`
   * and its 26 neighbours; nullptr where there is none. Valid until the next call. */
  const Surface* nearest(const Eigen::Vector3d& p, double reach_m);

  double voxel_m() const { return voxel_m_; }

  size_t voxels() const { return voxels_.size(); }

  size_t points() const;

 private:
  using Index = Eigen::Vector3i;

  struct Entry
  {
    Eigen::Vector3f p = Eigen::Vector3f::Zero();  // from the voxel's lowest corner
    uint32_t surface = 0;                         // of surfaces_, valid while `age` is age_
    uint32_t age = 0;
  };

  struct Voxel
  {
    Index index = Index::Zero();
    uint32_t size = 0;
    std::array<Entry, kMostPoints> entries;
  };

  Index indexOf(const Eigen::Vector3d& p) const;
  Eigen::Vector3d cornerOf(const Index& index) const;
  size_t slotOf(const Index& index) const;
  Voxel& findOrMake(const Index& index);
  void rehash(size_t slots);
  const Surface& surfaceOf(const Voxel& voxel, Entry& entry);
  Surface surfaceAround(const Index& home, const Eigen::Vector3d& p) const;

  double voxel_m_;
  double spacing_m_;
  std::vector<Voxel> voxels_;
  std::vector<uint32_t> slots_;  // open addressing: index into voxels_ + 1, 0 = free
  std::vector<Surface> surfaces_;
  uint32_t age_ = 1;
};
}  // namespace traverse::registration
