// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/formats/report.h>
#include <traverse/poses/timing.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace traverse::formats
{
using poses::StampGap;

/** The regularity of stamps that may come in any order, as a page shows it. */
struct StampRhythm
{
  std::optional<double> period_s;  //!< median of the steps forward in time; none below two stamps
  std::vector<StampGap> gaps;      //!< longer than three periods, by time; the kMostGaps longest
  size_t gap_count = 0;            //!< all of them
  double longest_gap_s = 0;        //!< 0 where there is none

  static constexpr size_t kMostGaps = 200;
};

StampRhythm rhythmOf(std::span<const int64_t> stamps_ns);
}  // namespace traverse::formats
