// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/exact_trig.h>
#include <traverse/navigation/cell_walk.h>
#include <traverse/navigation/costmap.h>

#include <cstdint>
#include <span>
#include <vector>

namespace traverse::navigation
{
/** Where a vehicle stands. */
struct Stand
{
  Place place;
  geometry::SinCos yaw;
};

inline Stand standAt(const geometry::Pose2& pose)
{
  return {{pose.x_m, pose.y_m}, geometry::sinCosOfAny(pose.yaw_rad)};
}

/** Cells [first, last] of a row. */
struct RowSpan
{
  int32_t y = 0;
  int32_t first = 0;
  int32_t last = 0;
};

/** Which cells a vehicle touches: the convex hull of its outline, with a margin where one is given
 * (of a square: at corners it is up to 1.4 times as wide). */
class Footprint
{
 public:
  explicit Footprint(const geometry::Vehicle& vehicle, double margin_m = 0);

  /** From the origin to the farthest corner. */
  double radius_m() const { return radius_m_; }

  /** All cells that it touches, row by row; valid until the next call. */
  std::span<const RowSpan> cells(const Stand& stand, const geometry::Lattice& lattice);

 private:
  struct Reach
  {
    double least = 0;
    double most = 0;
  };

  void addEdge(Place a, Place b, int32_t first_row);

  std::vector<Place> corners_;
  std::vector<Place> turned_;
  std::vector<Reach> reach_;
  std::vector<RowSpan> spans_;
  double radius_m_ = 0;
};

/** Counts of obstacle cells, by which any rectangle is asked at once (summed-area table). */
class ObstacleCounts
{
 public:
  /** `spared` do not count. */
  void set(const Costmap& costmap, std::span<const RowSpan> spared);

  /** One in [first, last] of both; cells outside the extent are free. */
  bool any(int32_t x_first, int32_t x_last, int32_t y_first, int32_t y_last) const;

  /** Under the footprint. */
  bool isHit(Footprint& footprint, const Stand& stand) const;

 private:
  geometry::Lattice lattice_;
  geometry::CellRect extent_;
  std::vector<int32_t> sums_;
};
}  // namespace traverse::navigation
