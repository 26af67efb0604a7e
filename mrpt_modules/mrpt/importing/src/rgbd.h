// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "entries.h"
#include "planned_source.h"

#include <string>
#include <vector>

namespace traverse::importing
{
/** What both RGB-D layouts share: the camera, and where it sits on the vehicle. */
struct RgbdRig
{
  std::string label;
  Camera camera;
  double metres_per_count = 0.001;
  Eigen::Isometry3d T_base_camera = Eigen::Isometry3d::Identity();  //!< x forward, z up
};

RgbdRig rgbdRig(const ImportParams& params, const Camera& usual);

/** A frame's pictures as a step; `colour` may be empty. */
Step depthStep(
    const RgbdRig& rig,
    const std::filesystem::path& depth,
    const std::filesystem::path& colour,
    poses::TimeNs stamp);

/** The pose of a camera's optical frame (z forward) as that of the vehicle. */
Step cameraPoseStep(
    const RgbdRig& rig, const Eigen::Isometry3d& T_world_optical, poses::TimeNs stamp);
}  // namespace traverse::importing
