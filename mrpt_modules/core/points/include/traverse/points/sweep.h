// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/points/decoded.h>

#include <optional>
#include <vector>

namespace traverse::points
{
/** When a sweep of a tilting scanner is over. */
struct SweepLimits
{
  double max_gap_s = 1.0;      //!< a longer pause between two rows ends a sweep
  double min_turn_rad = 2e-3;  //!< of the tilt, to know which way it goes
  size_t max_rows = 4096;
};

/** Collects successive rows of one tilting 2-D scanner (decodeRow()) into sweeps of two angles.
 *
 * A sweep ends when the tilt turns round, pauses, time goes back, or the number of beams changes.
 * The sweep's stamp is its first row's; every point has its row's time relative to that. Its sensor
 * frame is the first row's origin, level in pitch: there a beam at bearing b of a row at elevation
 * p has elevation asin(cos b sin p) and azimuth atan2(sin b, cos b cos p). Hits are measured from
 * that one origin (exact also for a tilting axis beside the scanner). The vehicle's own motion
 * during the sweep is left to deskew(). */
class SweepCollector
{
 public:
  explicit SweepCollector(const SweepLimits& limits = {}) : limits_(limits) {}

  /** Takes one row; returns the finished sweep where this row begins another one. */
  std::optional<Decoded> add(Decoded row);

  /** The sweep collected so far, which may be empty (nothing). */
  std::optional<Decoded> finish();

 private:
  bool continues(const Decoded& row) const;

  SweepLimits limits_;
  std::vector<Decoded> rows_;
  int direction_ = 0;        // of the tilt: -1, 0 not known yet, +1
  double furthest_rad_ = 0;  // tilt that the sweep has reached in that direction
};
}  // namespace traverse::points
