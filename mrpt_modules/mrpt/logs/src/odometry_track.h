// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "log_walk.h"

#include <optional>

namespace traverse::logs
{
/** The odometry of a log as stamped poses, from either of its two forms; the first one met is kept
 * to, as the other would start from another origin. */
class OdometryTrack
{
 public:
  /** False where the observation is no odometry (or of the form that is not kept to). Notes the
   * stamp of any observation for the frame it stands in. */
  bool add(const mrpt::obs::CObservation& observation);

  void add(const Movement& movement);
  void frameEnd();

  /** The pose that came with the last call, once; time 0 where no stamp was to be had. */
  std::optional<poses::StampedPose> take();

  /** Where the vehicle is now. */
  const Eigen::Isometry3d& pose() const { return pose_; }

  /** The log has odometry. */
  bool any() const { return form_ != Form::unknown; }

 private:
  enum class Form
  {
    unknown,
    observations,
    actions,
  };

  Form form_ = Form::unknown;
  Eigen::Isometry3d pose_ = Eigen::Isometry3d::Identity();
  std::optional<poses::TimeNs> action_stamp_;
  std::optional<poses::TimeNs> frame_stamp_;
  std::optional<poses::StampedPose> ready_;
  std::optional<poses::StampedPose> before_first_;  // of the last frame before any movement
};
}  // namespace traverse::logs
