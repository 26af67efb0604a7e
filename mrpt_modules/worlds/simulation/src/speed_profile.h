// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/simulation/drive.h>

#include <algorithm>
#include <cmath>

namespace traverse::simulation
{
/** The way along a line by time: it stands, drives off evenly, drives, stops evenly at the end. */
class SpeedProfile
{
 public:
  SpeedProfile(const DriveParams& params, double length_m) :
      start_s_(params.start_s), length_m_(length_m), accel_mps2_(params.accel_mps2)
  {
    speed_mps_ = accel_mps2_ > 0 ? std::min(params.speed_mps, std::sqrt(accel_mps2_ * length_m))
                                 : params.speed_mps;
    ramp_s_ = accel_mps2_ > 0 ? speed_mps_ / accel_mps2_ : 0;
    drive_s_ = length_m > 0 ? length_m / speed_mps_ + ramp_s_ : 0;
  }

  /** When it is at the end of the line. */
  double endSeconds() const { return start_s_ + drive_s_; }

  double wayAt(double t_s) const
  {
    const double t = std::clamp(t_s - start_s_, 0.0, drive_s_);
    const double left = drive_s_ - t;
    if (t < ramp_s_)
    {
      return std::min(accel_mps2_ * t * t / 2, length_m_);
    }
    if (left < ramp_s_)
    {
      return std::max(length_m_ - accel_mps2_ * left * left / 2, 0.0);
    }
    return std::min(speed_mps_ * (t - ramp_s_ / 2), length_m_);
  }

 private:
  double start_s_;
  double length_m_;
  double accel_mps2_;
  double speed_mps_ = 0;
  double ramp_s_ = 0;
  double drive_s_ = 0;
};
}  // namespace traverse::simulation
