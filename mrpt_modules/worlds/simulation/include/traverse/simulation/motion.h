// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include <vector>

namespace traverse::simulation
{
/** Where something is, seconds after the scene's beginning. */
struct TimedPose
{
  double t_s = 0;
  Eigen::Isometry3d T_map_body = Eigen::Isometry3d::Identity();
};

/** The exact pose of what moves, at any time: between two given ones along the constant twist
 * between them; before the first and behind the last it stands. The same bits everywhere. */
class Motion
{
 public:
  /** Stands at map zero for ever. */
  Motion() = default;

  /** Times must grow, and there must be one pose at least; throws std::invalid_argument. */
  explicit Motion(std::vector<TimedPose> poses);

  Eigen::Isometry3d at(double t_s) const;

  bool moves() const { return poses_.size() > 1; }

  const std::vector<TimedPose>& poses() const { return poses_; }

 private:
  std::vector<TimedPose> poses_ = {TimedPose{}};
};
}  // namespace traverse::simulation
