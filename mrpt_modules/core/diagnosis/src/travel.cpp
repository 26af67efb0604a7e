// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/diagnosis/travel.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace traverse::diagnosis
{
Travel travelOf(const poses::PoseTrack& track)
{
  constexpr double kNoise_m = 0.05;  // shorter steps say little of the direction
  Travel travel;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  const auto all = track.poses();
  size_t from = 0;
  for (size_t i = 1; i < all.size(); ++i)
  {
    if (track.at(all[from].time)->segment != track.at(all[i].time)->segment)
    {
      from = i;
      continue;
    }
    const Eigen::Isometry3d step = all[from].T_map_base.inverse() * all[i].T_map_base;
    const double length_m = step.translation().norm();
    if (length_m < kNoise_m)
    {
      continue;
    }
    travel.distance_m += length_m;
    travel.top_speed_mps = std::max(
        travel.top_speed_mps, length_m / poses::secondsBetween(all[from].time, all[i].time));
    sum += step.translation();
    from = i;
  }
  if (travel.distance_m > 0)
  {
    travel.heading_deg = std::atan2(sum.y(), sum.x()) * 180 / std::numbers::pi;
    travel.share = sum.norm() / travel.distance_m;
  }
  return travel;
}
}  // namespace traverse::diagnosis
