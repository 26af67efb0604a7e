// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/nav_app/run_params.h>
#include <traverse/navigation/planner.h>
#include <traverse/poses/pose_track.h>

#include <optional>
#include <vector>

namespace traverse::app
{
/** Where a replayed vehicle is to go: the ini's goals, or places of the way that it drove. */
class RecordedGoals
{
 public:
  RecordedGoals(const poses::PoseTrack& track, const NavParams& params);

  /** The goal to turn to now, where that is another one than before. Times must not go back. */
  std::optional<navigation::Goal> next(poses::TimeNs now);

 private:
  struct Timed
  {
    navigation::Goal goal;
    poses::TimeNs until = 0;
  };

  void ofIni(const poses::PoseTrack& track, const NavParams& params);
  void alongTrack(const poses::PoseTrack& track, double every_m);

  std::vector<Timed> goals_;
  size_t at_ = 0;
  bool is_new_ = true;
};
}  // namespace traverse::app
