// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/points/scan.h>
#include <traverse/poses/pose_track.h>

namespace traverse::points
{
/** What deskew() did. */
enum class Deskew : uint8_t
{
  corrected,
  not_needed,  //!< no per-point times, or a track of one constant pose
  no_poses,    //!< a point's time has no valid pose, or lies in another segment: left as it was
};

/** Moves every point from the vehicle frame of its own time to that of scan.stamp:
 * p' = T_map_base(stamp)^-1 T_map_base(stamp + time_s) p, with poses interpolated on SE(3). */
Deskew deskew(ScanBuffer& scan, const poses::PoseTrack& track);
}  // namespace traverse::points
