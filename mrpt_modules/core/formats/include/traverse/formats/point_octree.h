// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/formats/octomap_params.h>
#include <traverse/formats/octree_file.h>
#include <traverse/layers/scan_consumer.h>
#include <traverse/points/scan.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace traverse::formats
{
/** What became of the points that an octree was given. */
struct OctreeCounts
{
  uint64_t points = 0;       //!< in a leaf now
  uint64_t bad_points = 0;   //!< NaN, Inf, or further than anything on the ground
  uint64_t beyond = 0;       //!< more than 32768 leaves from map zero along an axis
  uint64_t over_budget = 0;  //!< max_memory_mb had no room for their leaf
};

/** The points of a map's scans as an OctoMap: a leaf is occupied where a point fell, and unknown
 * everywhere else (no rays are cast). A leaf that was hit has one fixed value however often it was,
 * so that the files do not depend on the order of the scans, unless max_memory_mb was reached.
 *
 * Every finite point counts, also those that the map itself leaves out, has forgotten or has no
 * room for. Leaves lie on the map's own lattice. Copying copies all leaves. */
class PointOctree
{
 public:
  /** Off: keeps nothing. */
  PointOctree();

  /** Off where the resolution is 0. Throws OptionError for what check() refuses. */
  explicit PointOctree(const OctomapParams& params);
  PointOctree(const PointOctree& other);
  PointOctree(PointOctree&&) noexcept;
  PointOctree& operator=(const PointOctree& other);
  PointOctree& operator=(PointOctree&&) noexcept;
  ~PointOctree();

  /** An octree without points takes these options; one with points must have been made with the
   * same resolution, otherwise std::invalid_argument. */
  void adopt(const OctomapParams& params);

  /** Adds the points of a deskewed scan taken at T_map_base. */
  void insert(const points::Scan& scan, const Eigen::Isometry3d& T_map_base);

  bool empty() const;

  const OctreeCounts& counts() const { return counts_; }

  /** OctoMap's binary format: which leaves are occupied. */
  std::string bt() const;

  /** OctoMap's full format: leaves with their (one) log-odds. */
  std::string ot() const;

  /** The octree of bt(). Throws FormatError for bytes that are none, hold another resolution, free
   * leaves, or more than max_memory_mb. */
  static PointOctree fromBt(std::string_view bytes, const OctomapParams& params);

  /** Adds the leaves of a bt() of the same resolution. Throws FormatError as fromBt() does, and
   * std::length_error beyond max_memory_mb; the octree is then as it was, or has some of them. */
  void merge(std::string_view bt);

  /** ".bt" and ".ot"; nothing for an octree without points. */
  std::vector<layers::ExtraFile> files() const;

  /** What a user must know of points that the octree did not take. */
  std::vector<std::string> warnings() const;

 private:
  struct Tree;

  /** False where max_memory_mb has no room for the leaf. */
  bool take(const OctreeKey& key);

  /** FormatError for what fromBt() refuses. */
  OctreeSummary checkOwn(std::string_view bytes) const;

  OctomapParams params_;
  OctreeCounts counts_;
  std::unique_ptr<Tree> tree_;  // no OctoMap where the octree is off
};
}  // namespace traverse::formats
