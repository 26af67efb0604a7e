// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "beam_points.h"

#include <traverse/points/scan.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace traverse::multi_lidar_grid
{
/** A beam as seen from the side: it goes along the ground by reach_m, and up by slope times that.
 */
struct FanBeam
{
  float reach_m = 0;
  float slope = 0;
  bool is_hit = true;  //!< something was met there; false: it goes on unseen
};

/** A direction in the map frame. */
struct Direction
{
  float x = 1;
  float y = 0;
};

/** The beams of a scan by azimuth, as fans of beams above each other. Of several beams of one laser
 * in one fan the nearest stands for all. */
class BeamFans
{
 public:
  /** Sorts a scan's beams into fans as wide as the steps between its beams. */
  void collect(const points::Scan& scan, const BeamPoints& points);

  /** A beam that met nothing up to beam.reach_m. */
  struct Empty
  {
    float turn = 0;
    size_t row = 0;  //!< of its image, 0 lowest
    FanBeam beam;
    float time_s = 0;
  };

  /** Adds it where no other beam of its laser is in the fan. */
  void addEmpty(const Empty& empty);

  /** After collect() and addEmpty(): makes beams(). */
  void sort();

  int32_t count() const { return fans_; }

  /** Azimuth covered by a fan, rad. */
  float width_rad() const { return width_rad_; }

  /** The fan of an azimuth in turns, counter-clockwise from x of the map. */
  size_t fanOf(float turn) const;

  /** A fan's middle, or `part` of its width from it (-0.5 to 0.5). */
  Direction direction(int32_t fan, float part) const
  {
    const Direction& d = middles_[static_cast<size_t>(fan)];
    const float angle = part * width_rad_;  // less than 0.01: the first terms do
    const float c = 1 - angle * angle / 2;
    return {d.x * c - d.y * angle, d.y * c + d.x * angle};
  }

  /** The time at which a fan was looked at, relative to the stamp, s. */
  float time_s(int32_t fan) const { return times_[static_cast<size_t>(fan)]; }

  /** A fan's beams by growing slope. */
  std::span<const FanBeam> beams(size_t fan) const
  {
    return {table_.data() + fan * static_cast<size_t>(rows_), counts_[fan]};
  }

  /** Whether all beams are of one row and about level: a 2-D scanner's. */
  bool isLevelRow() const { return rows_ <= 1 && steepest_ < 0.1F; }

 private:
  /** Which rows of a fan have a beam. */
  using Rows = std::array<uint64_t, 4>;

  static bool has(const Rows& rows, size_t row) { return (rows[row / 64] >> (row % 64) & 1U) != 0; }

  void layOut(const points::Scan& scan, const BeamPoints& points);
  void setFans(int32_t fans);
  size_t levelOf(float slope) const;
  void findLevels(const BeamPoints& points);
  double usualStep(const points::Scan& scan, const BeamPoints& points);

  int32_t fans_ = 0;
  int32_t rows_ = 0;
  float steepest_ = 0;  // slope of all beams, up or down
  bool has_rings_ = false;
  float width_rad_ = 0;
  float lowest_ = 0;  // without rings: sines of elevation that the rows divide evenly
  float rows_per_sine_ = 0;
  std::vector<FanBeam> table_;  // fans x rows; of a fan those in has_beam_, once sorted the first
  std::vector<Rows> has_beam_;
  std::vector<uint16_t> counts_;  // of sorted beams
  std::vector<float> times_;
  std::vector<Direction> middles_;
  std::vector<float> steps_;
  std::vector<uint32_t> ring_counts_;
};
}  // namespace traverse::multi_lidar_grid
