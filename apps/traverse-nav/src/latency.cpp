// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/nav_app/latency.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace traverse::app
{
double Latencies::percentileMs(Stage stage, double share) const
{
  std::vector<float> times = times_ms_[static_cast<size_t>(stage)];
  if (times.empty())
  {
    return 0;
  }
  const auto last = static_cast<double>(times.size() - 1);
  const auto nth = times.begin() + static_cast<std::ptrdiff_t>(std::lround(last * share));
  std::nth_element(times.begin(), nth, times.end());
  return *nth;
}

double Latencies::totalMs(Stage stage) const
{
  const std::vector<float>& times = times_ms_[static_cast<size_t>(stage)];
  return std::accumulate(times.begin(), times.end(), 0.0);
}

double Latencies::shareAbove(Stage stage, double limit_ms) const
{
  const std::vector<float>& times = times_ms_[static_cast<size_t>(stage)];
  const auto above = std::count_if(
      times.begin(), times.end(), [&](float ms) { return static_cast<double>(ms) > limit_ms; });
  return times.empty() ? 0 : static_cast<double>(above) / static_cast<double>(times.size());
}
}  // namespace traverse::app
