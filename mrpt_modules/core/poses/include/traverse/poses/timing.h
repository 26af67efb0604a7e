// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/poses/pose_track.h>

#include <span>
#include <vector>

namespace traverse::poses
{
/** As secondsBetween(), for stamps in order; exact for any two of 64 bits. */
inline double secondsFrom(TimeNs earlier, TimeNs later)
{
  return static_cast<double>(static_cast<uint64_t>(later) - static_cast<uint64_t>(earlier)) / 1e9;
}

/** A silence between two stamps that follow each other in time. */
struct StampGap
{
  TimeNs from_ns = 0;
  TimeNs to_ns = 0;

  double seconds() const { return secondsFrom(from_ns, to_ns); }
};

/** How regularly a sensor spoke. */
struct Timing
{
  double median_period_s = 0;  //!< 0 where there are fewer than two different stamps
  double shortest_period_s = 0;
  double longest_period_s = 0;
  std::vector<StampGap> gaps;  //!< longer than kGapPeriods median periods; by time
  size_t backward = 0;         //!< stamps before their predecessor's in the order given
  size_t repeated = 0;         //!< stamps that are there more than once

  static constexpr double kGapPeriods = 3;

  double rateHz() const { return median_period_s > 0 ? 1 / median_period_s : 0; }
};

/** From stamps in the order of their arrival. */
Timing timingOf(std::span<const TimeNs> stamps);
}  // namespace traverse::poses
