// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/navigation/supervisor.h>

#include <string>

namespace traverse::testing
{
inline constexpr poses::TimeNs kStart = 1'600'000'000'000'000'000;
inline constexpr double kStep_s = 0.05;
inline constexpr double kTolerance_m = 0.5;

/** A vehicle that drives along x at 1 m/s and steps its supervisor at 20 Hz, all being well. */
class SupervisedDrive
{
 public:
  explicit SupervisedDrive(const navigation::WatchdogParams& params = {}) :
      supervisor(params, kTolerance_m)
  {
  }

  /** change(Situation&) is told each step's situation before the supervisor is. */
  template <class F>
  navigation::Conduct run(double seconds, F&& change)
  {
    navigation::Conduct conduct = navigation::Conduct::stop;
    const int steps = static_cast<int>(seconds / kStep_s + 0.5);
    for (int i = 0; i < steps; ++i)
    {
      time_s_ += kStep_s;
      navigation::Situation now;
      now.now = poses::later(kStart, time_s_);
      now.last_scan = now.last_pose = now.now;
      now.pose.x_m = time_s_;
      now.has_way = now.has_motion = now.wants_motion = true;
      now.to_goal_m = 100;
      change(now);
      conduct = supervisor.step(now);
    }
    return conduct;
  }

  navigation::Conduct run(double seconds)
  {
    return run(seconds, [](navigation::Situation&) {});
  }

  /** "drive, stop stale_map, ..." */
  std::string told() const
  {
    std::string text;
    for (const navigation::Decision& decision : supervisor.log())
    {
      text += (text.empty() ? "" : ", ") + std::string(navigation::nameOf(decision.conduct));
      text += decision.cause == navigation::Cause::none
                  ? ""
                  : " " + std::string(navigation::nameOf(decision.cause));
    }
    return text;
  }

  /** Of the last decision, s after the beginning. */
  double lastTime_s() const { return poses::secondsBetween(kStart, supervisor.log().back().time); }

  navigation::Supervisor supervisor;

 private:
  double time_s_ = 0;
};
}  // namespace traverse::testing
