// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/diagnosis/timing.h>

#include <algorithm>

namespace traverse::diagnosis
{
Timing timingOf(std::span<const poses::TimeNs> stamps)
{
  Timing timing;
  for (size_t i = 1; i < stamps.size(); ++i)
  {
    timing.backward += stamps[i] < stamps[i - 1] ? 1 : 0;
  }
  std::vector<poses::TimeNs> sorted(stamps.begin(), stamps.end());
  std::sort(sorted.begin(), sorted.end());
  const auto unique_end = std::unique(sorted.begin(), sorted.end());
  timing.repeated = static_cast<size_t>(sorted.end() - unique_end);
  sorted.erase(unique_end, sorted.end());
  if (sorted.size() < 2)
  {
    return timing;
  }
  std::vector<poses::TimeNs> periods(sorted.size() - 1);
  for (size_t i = 0; i < periods.size(); ++i)
  {
    periods[i] = sorted[i + 1] - sorted[i];
  }
  const auto middle = periods.begin() + static_cast<std::ptrdiff_t>(periods.size() / 2);
  std::nth_element(periods.begin(), middle, periods.end());
  timing.median_period_s = poses::secondsBetween(0, *middle);
  const auto [shortest, longest] = std::minmax_element(periods.begin(), periods.end());
  timing.shortest_period_s = poses::secondsBetween(0, *shortest);
  timing.longest_period_s = poses::secondsBetween(0, *longest);
  for (size_t i = 0; i + 1 < sorted.size(); ++i)
  {
    const Gap gap{sorted[i], sorted[i + 1]};
    if (gap.seconds() > Timing::kGapPeriods * timing.median_period_s)
    {
      timing.gaps.push_back(gap);
    }
  }
  return timing;
}
}  // namespace traverse::diagnosis
