// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rgbd.h"

#include "folders.h"

namespace traverse::importing
{
RgbdRig rgbdRig(const ImportParams& params, const Camera& usual)
{
  RgbdRig rig;
  rig.label = params.sensor_label.empty() ? "RGBD" : params.sensor_label;
  rig.camera = usual;
  if (params.camera)
  {
    const auto& c = *params.camera;
    rig.camera = {c[0], c[1], c[2], c[3]};
  }
  if (rig.camera.fx < 1 || rig.camera.fy < 1)
  {
    throw ImportError("the camera's focal lengths are below one pixel");
  }
  rig.T_base_camera = params.T_base_sensor.value_or(Eigen::Isometry3d::Identity());
  return rig;
}

Step depthStep(
    const RgbdRig& rig,
    const std::filesystem::path& depth,
    const std::filesystem::path& colour,
    poses::TimeNs stamp)
{
  const DepthFrame frame = {depth, colour, rig.metres_per_count, rig.camera};
  const SensorAt sensor = {rig.label, rig.T_base_camera, stamp};
  return {stamp, [frame, sensor] { return depthEntry(frame, sensor); }};
}

Step cameraPoseStep(
    const RgbdRig& rig, const Eigen::Isometry3d& T_world_optical, poses::TimeNs stamp)
{
  const Eigen::Isometry3d T_world_camera = T_world_optical * fromOptical().inverse();
  const poses::StampedPose pose = {stamp, T_world_camera * rig.T_base_camera.inverse()};
  return {stamp, [pose] { return poseEntry(pose); }};
}
}  // namespace traverse::importing
