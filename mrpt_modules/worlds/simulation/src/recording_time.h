// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/simulation/lidar.h>

#include <cmath>
#include <cstdint>

namespace traverse::simulation
{
/** Seconds as whole nanoseconds. */
inline int64_t nsOf(double seconds)
{
  return static_cast<int64_t>(std::floor(seconds * 1e9 + 0.5));
}

/** Whole nanoseconds as seconds. */
inline double secondsOf(int64_t ns)
{
  return static_cast<double>(ns) * poses::kSecondsPerNs;
}

/** When the k-th of so many a second is due, ns of the recording. */
inline int64_t dueNs(uint64_t k, double rate_hz)
{
  return nsOf(static_cast<double>(k) / rate_hz);
}

/** How many of so many a second are due by then, the one at 0 s included. */
inline uint64_t dueUntil(double end_s, double rate_hz)
{
  return rate_hz > 0 && end_s >= 0 ? static_cast<uint64_t>(std::floor(end_s * rate_hz + 1e-9)) + 1
                                   : 0;
}

/** The end of what is said, where silence from a time on may be asked for (0: never). */
inline double endWith(double end_s, double dead_after_s)
{
  return dead_after_s > 0 && dead_after_s < end_s ? dead_after_s : end_s;
}
}  // namespace traverse::simulation
