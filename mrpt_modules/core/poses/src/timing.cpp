// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/poses/timing.h>

#include <algorithm>

namespace traverse::poses
{
Timing timingOf(std::span<const TimeNs> stamps)
{
  Timing timing;
  for (size_t i = 1; i < stamps.size(); ++i)
  {
    timing.backward += stamps[i] < stamps[i - 1] ? 1 : 0;
  }
  std::vector<TimeNs> sorted(stamps.begin(), stamps.end());
  std::sort(sorted.begin(), sorted.end());
  const auto unique_end = std::unique(sorted.begin(), sorted.end());
  timing.repeated = static_cast<size_t>(sorted.end() - unique_end);
  sorted.erase(unique_end, sorted.end());
  if (sorted.size() < 2)
  {
    return timing;
  }
  std::vector<double> periods_s(sorted.size() - 1);
  for (size_t i = 0; i < periods_s.size(); ++i)
  {
    periods_s[i] = secondsFrom(sorted[i], sorted[i + 1]);
  }
  const auto middle = periods_s.begin() + static_cast<std::ptrdiff_t>(periods_s.size() / 2);
  std::nth_element(periods_s.begin(), middle, periods_s.end());
  timing.median_period_s = *middle;
  const auto [shortest, longest] = std::minmax_element(periods_s.begin(), periods_s.end());
  timing.shortest_period_s = *shortest;
  timing.longest_period_s = *longest;
  for (size_t i = 0; i + 1 < sorted.size(); ++i)
  {
    const StampGap gap{sorted[i], sorted[i + 1]};
    if (gap.seconds() > Timing::kGapPeriods * timing.median_period_s)
    {
      timing.gaps.push_back(gap);
    }
  }
  return timing;
}
}  // namespace traverse::poses
