// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <string_view>
#include <vector>

namespace traverse::app
{
/** The stages of a pilot. */
enum class Stage : uint8_t
{
  maps,  //!< a scan into all maps
  costmap,
  plan,
  reactive,  //!< with speed limit and watchdogs
  control,   //!< a whole control step, plan and costmap included
};

inline constexpr std::array<std::string_view, 5> kStageNames = {
    "maps", "costmap", "plan", "reactive", "control"};

/** How long each stage took, every time. */
class Latencies
{
 public:
  /** Runs f and keeps its time. */
  template <class F>
  auto time(Stage stage, F&& f)
  {
    const Watch watch{times_ms_[static_cast<size_t>(stage)]};
    return f();
  }

  /** A share of a stage's times is below this, ms; 0 where it never ran. 0 < share <= 1. */
  double percentileMs(Stage stage, double share) const;

  /** Of all its times together, ms. */
  double totalMs(Stage stage) const;

  /** Share of its times above a limit; 0 where it never ran. */
  double shareAbove(Stage stage, double limit_ms) const;

  uint64_t count(Stage stage) const { return times_ms_[static_cast<size_t>(stage)].size(); }

 private:
  using Clock = std::chrono::steady_clock;

  struct Watch
  {
    std::vector<float>& times_ms;
    Clock::time_point start = Clock::now();

    ~Watch()
    {
      const std::chrono::duration<float, std::milli> took = Clock::now() - start;
      times_ms.push_back(took.count());
    }
  };

  std::array<std::vector<float>, kStageNames.size()> times_ms_;
};
}  // namespace traverse::app
