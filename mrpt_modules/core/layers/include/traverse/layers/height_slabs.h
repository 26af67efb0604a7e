// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/poses/pose_track.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>

namespace traverse::layers
{
/** A point within its cell and slab: millimetres from the cell's corner of smallest x and y, and
 * from the slab's bottom. */
struct PointInSlab
{
  uint16_t x_mm = 0;
  uint16_t y_mm = 0;
  uint16_t z_mm = 0;
};

/** Integer sums over the points of one cell in one height slab.
 *
 * Slab `level` holds the heights [level, level + 1) * slab height above map zero, whatever came
 * first, so that points add up to the same bits in any order. All sums are of millimetres relative
 * to the cell's corner and the slab's bottom: coordinates stay below 2^15, products below 2^30, and
 * sums of kMostPoints of them below 2^62. */
struct HeightSlab
{
  static constexpr uint32_t kMostPoints = std::numeric_limits<uint32_t>::max();

  int32_t level = 0;
  int32_t next = -1;  //!< the cell's next higher slab, or -1: see HeightSlabs
  uint32_t n = 0;
  uint16_t min_z_mm = 0;
  uint16_t max_z_mm = 0;
  poses::TimeNs last_seen = 0;
  int64_t x = 0, y = 0, z = 0;
  int64_t xx = 0, xy = 0, yy = 0, xz = 0, yz = 0, zz = 0;
  int64_t noise = 0;     //!< variances of the heights that the sensor's noise makes, (0.1 mm)^2
  uint32_t seen_by = 0;  //!< bits of the sensors that saw it at last_seen
  uint32_t level_n = 0;  //!< of the n points, those that were met at their sensor's own height

  void add(PointInSlab p, poses::TimeNs stamp);

  /** As if the other's points had been added here; same level. */
  void add(const HeightSlab& other);
};

static_assert(sizeof(HeightSlab) == 112, "two cache lines at most");

/** The slabs of all cells of a map. A cell owns a list of them, lowest first, and knows only the
 * list's head (kNone where it has no point). Freed slabs are used again. */
class HeightSlabs
{
 public:
  static constexpr int32_t kNone = -1;

  /** At most so many slabs are in use (2^31 - 1 at most); they take sizeof(HeightSlab) each. */
  void setMost(size_t most) { most_ = most < kMost ? most : kMost; }

  /** The slab of that level in the list, made where it is missing; nullptr where there are `most`
   * slabs already. `head` may change. */
  HeightSlab* obtain(int32_t& head, int32_t level);

  /** Gives the list's slabs back; `head` is kNone afterwards. */
  void release(int32_t& head);

  void clear();

  /** nullptr for kNone. */
  const HeightSlab* get(int32_t slab) const { return slab == kNone ? nullptr : &at(slab); }

  /** Sends for a slab that will be needed soon; nothing for kNone. */
  void prefetch(int32_t slab) const
  {
    if (slab != kNone)
    {
      const HeightSlab* s = &at(slab);
      __builtin_prefetch(s);
      __builtin_prefetch(&s->seen_by);
    }
  }

  /** Slabs in use. */
  size_t size() const { return used_; }

 private:
  static constexpr size_t kMost = static_cast<size_t>(std::numeric_limits<int32_t>::max());
  static constexpr size_t kChunk = 4096;
  using Chunk = std::array<HeightSlab, kChunk>;

  const HeightSlab& at(int32_t i) const
  {
    return chunks_[static_cast<size_t>(i) / kChunk][static_cast<size_t>(i) % kChunk];
  }

  HeightSlab& at(int32_t i)
  {
    return chunks_[static_cast<size_t>(i) / kChunk][static_cast<size_t>(i) % kChunk];
  }

  int32_t take();

  std::deque<Chunk> chunks_;  // growing one never moves the others
  size_t most_ = kMost;
  size_t made_ = 0;
  size_t used_ = 0;
  int32_t free_ = kNone;
};

inline void HeightSlab::add(PointInSlab p, poses::TimeNs stamp)
{
  const int64_t px = p.x_mm;
  const int64_t py = p.y_mm;
  const int64_t pz = p.z_mm;
  min_z_mm = n == 0 || p.z_mm < min_z_mm ? p.z_mm : min_z_mm;
  max_z_mm = n == 0 || p.z_mm > max_z_mm ? p.z_mm : max_z_mm;
  last_seen = n == 0 || stamp > last_seen ? stamp : last_seen;
  ++n;
  x += px;
  y += py;
  z += pz;
  xx += px * px;
  xy += px * py;
  yy += py * py;
  xz += px * pz;
  yz += py * pz;
  zz += pz * pz;
}

inline void HeightSlab::add(const HeightSlab& other)
{
  min_z_mm = n == 0 || other.min_z_mm < min_z_mm ? other.min_z_mm : min_z_mm;
  max_z_mm = n == 0 || other.max_z_mm > max_z_mm ? other.max_z_mm : max_z_mm;
  const bool is_newer = n == 0 || other.last_seen > last_seen;
  seen_by = is_newer ? other.seen_by : seen_by | (other.last_seen == last_seen ? other.seen_by : 0);
  last_seen = is_newer ? other.last_seen : last_seen;
  n += other.n;
  x += other.x;
  y += other.y;
  z += other.z;
  xx += other.xx;
  xy += other.xy;
  yy += other.yy;
  xz += other.xz;
  yz += other.yz;
  zz += other.zz;
  noise += other.noise;
  level_n += other.level_n;
}
}  // namespace traverse::layers
