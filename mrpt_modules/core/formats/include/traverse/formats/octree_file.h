// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace traverse::formats
{
/** A leaf of the finest size by OctoMap's key of each axis: along an axis leaf k covers
 * [k - 32768, k - 32767) times the resolution. */
struct OctreeKey
{
  static constexpr int32_t kZero = 32768;  //!< the key of the leaf that begins at map zero

  uint16_t x = 0;
  uint16_t y = 0;
  uint16_t z = 0;

  friend bool operator==(const OctreeKey&, const OctreeKey&) = default;
};

/** Middle of leaf k along its axis, metres in the map frame. */
inline double leafCentre_m(uint16_t k, double resolution_m)
{
  return (static_cast<double>(int32_t{k} - OctreeKey::kZero) + 0.5) * resolution_m;
}

/** What a .bt or .ot file of OctoMap says of itself. */
struct OctreeSummary
{
  double resolution_m = 0;
  uint64_t nodes = 0;
  uint64_t occupied_leaves = 0;  //!< of the finest size: a pruned leaf is as many as it covers
  uint64_t free_leaves = 0;      //!< leaves known to be free, of any size
  std::string_view tree;         //!< the part of the bytes behind the header
};

/** Looks through the bytes of a .bt or .ot file, which may be hostile: OctoMap's own reader
 * believes them. Nothing is allocated; `tree` looks into the caller's bytes. Throws FormatError for
 * anything but a whole octree of the type OcTree. */
OctreeSummary checkOctree(std::string_view bytes);

/** The occupied leaves of an octree. */
struct Octree
{
  double resolution_m = 0;
  std::vector<OctreeKey> occupied;  //!< of the finest size, in the file's order
};

inline constexpr size_t kMostLeaves = 200'000'000;
inline constexpr size_t kMostOctreeFile = size_t{1} << 30U;

/** The same, read. Throws FormatError as checkOctree() does, and for more than `most_leaves`. */
Octree readOctree(std::string_view bytes, size_t most_leaves = kMostLeaves);
}  // namespace traverse::formats
