// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/poses/pose_track.h>

#include <Eigen/Geometry>

#include <array>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>

namespace traverse::importing
{
/** 2000-01-01: where recordings without a clock begin. */
inline constexpr poses::TimeNs kNoClockStart = 946'684'800'000'000'000;

/** What to import, and what the recording does not say itself. */
struct ImportParams
{
  std::filesystem::path input;
  std::string sensor_label;                        //!< of the range sensor; empty: the format's own
  std::optional<Eigen::Isometry3d> T_base_sensor;  //!< of that sensor; none: the format's own
  double rate_hz = 0;  //!< of clouds and images that have no stamps; 0: the format's own
  poses::TimeNs start = kNoClockStart;  //!< of a recording without a clock
  double from_s = 0;                    //!< seconds after the first observation, included
  double to_s = std::numeric_limits<double>::infinity();  //!< likewise, not included
  std::optional<std::array<double, 4>> camera;            //!< fx fy cx cy of RGB-D images, pixels

  double rateOr(double usual_hz) const { return rate_hz > 0 ? rate_hz : usual_hz; }
};
}  // namespace traverse::importing
