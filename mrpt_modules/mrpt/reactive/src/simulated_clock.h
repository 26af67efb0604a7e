// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/poses/pose_track.h>

#include <mrpt/core/Clock.h>

namespace traverse::reactive
{
/** The time as MRPT writes it: units of 100 ns since 1601. */
inline mrpt::Clock::time_point mrptTime(poses::TimeNs time)
{
  constexpr int64_t kNsPerTick = 100;
  constexpr int64_t kTicksTo1970 = 116'444'736'000'000'000;
  return mrpt::Clock::time_point(mrpt::Clock::duration(time / kNsPerTick + kTicksTo1970));
}

/** While it lives, MRPT's clock (one per process) stands still at a time; then it is again what it
 * was. */
class SimulatedClock
{
 public:
  explicit SimulatedClock(poses::TimeNs time) :
      source_(mrpt::Clock::getActiveClock()), time_(mrpt::Clock::now())
  {
    mrpt::Clock::setSimulatedTime(mrptTime(time));
    mrpt::Clock::setActiveClock(mrpt::Clock::Simulated);
  }

  ~SimulatedClock()
  {
    mrpt::Clock::setActiveClock(source_);
    if (source_ == mrpt::Clock::Simulated)
    {
      mrpt::Clock::setSimulatedTime(time_);
    }
  }

  SimulatedClock(const SimulatedClock&) = delete;
  SimulatedClock& operator=(const SimulatedClock&) = delete;

 private:
  mrpt::Clock::Source source_;
  mrpt::Clock::time_point time_;
};
}  // namespace traverse::reactive
