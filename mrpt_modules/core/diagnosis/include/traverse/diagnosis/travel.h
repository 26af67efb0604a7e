// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/poses/pose_track.h>

namespace traverse::diagnosis
{
/** Where a vehicle went, as seen from itself. */
struct Travel
{
  double distance_m = 0;
  double top_speed_mps = 0;

  /** Mean direction of travel in the vehicle frame, weighted by distance; 0 is along x, positive to
   * the left. Near 0 for what drives forward, near 180 for what backs, near 90 where y is forward.
   */
  double heading_deg = 0;

  /** How much of the distance went that way, 0..1: low where the vehicle moved to and fro. */
  double share = 0;
};

/** From the poses of a track; jumps between segments do not count. */
Travel travelOf(const poses::PoseTrack& track);
}  // namespace traverse::diagnosis
