// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/poses/pose_track.h>
#include <traverse/simulation/motion.h>

#include <algorithm>
#include <stdexcept>

namespace traverse::simulation
{
Motion::Motion(std::vector<TimedPose> poses) : poses_(std::move(poses))
{
  const auto not_later = [](const TimedPose& a, const TimedPose& b) { return !(a.t_s < b.t_s); };
  if (poses_.empty() || std::adjacent_find(poses_.begin(), poses_.end(), not_later) != poses_.end())
  {
    throw std::invalid_argument("a motion needs poses at growing times");
  }
}

Eigen::Isometry3d Motion::at(double t_s) const
{
  const auto later = std::upper_bound(
      poses_.begin(), poses_.end(), t_s, [](double t, const TimedPose& p) { return t < p.t_s; });
  if (later == poses_.begin() || later == poses_.end())
  {
    return later == poses_.begin() ? poses_.front().T_map_body : poses_.back().T_map_body;
  }
  const TimedPose& before = *(later - 1);
  const double fraction = (t_s - before.t_s) / (later->t_s - before.t_s);
  return poses::interpolate(before.T_map_body, later->T_map_body, fraction);
}
}  // namespace traverse::simulation
