// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kitti_camera.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace traverse::importing
{
std::optional<KittiCamera> kittiCamera(const std::vector<double>& projection)
{
  const bool finite =
      std::all_of(projection.begin(), projection.end(), [](double v) { return std::abs(v) < 1e6; });
  if (projection.size() != 12 || !finite || projection[0] < 1 || projection[5] < 1)
  {
    return std::nullopt;
  }
  KittiCamera camera;
  camera.pinhole = {projection[0], projection[5], projection[2], projection[6]};
  // P = K [1 | t] with t = -(position of the camera in the rectified frame of camera 0).
  camera.T_cam0_camera.translation() = -Eigen::Vector3d(
      (projection[3] - projection[2] * projection[11]) / projection[0],
      (projection[7] - projection[6] * projection[11]) / projection[5], projection[11]);
  return camera;
}

void addPictures(
    const KittiPictures& pictures,
    const std::function<std::optional<poses::TimeNs>(const std::filesystem::path&, size_t)>&
        stamp_of,
    std::vector<Step>& steps)
{
  const auto files = filesOf(pictures.folder, {".png", ".jpg"});
  for (size_t i = 0; i < files.size(); ++i)
  {
    const auto stamp = stamp_of(files[i], i);
    if (!stamp)
    {
      continue;
    }
    const SensorAt sensor = {pictures.label, pictures.T_base_camera, *stamp};
    steps.push_back({stamp, [file = files[i], sensor, pinhole = pictures.pinhole] {
                       return imageEntry(file, sensor, pinhole);
                     }});
  }
}

std::optional<size_t> frameNumber(const std::filesystem::path& file)
{
  const std::string stem = stemOf(file);
  size_t number = 0;
  const auto [end, error] = std::from_chars(stem.data(), stem.data() + stem.size(), number);
  const bool whole = error == std::errc() && end == stem.data() + stem.size();
  return whole ? std::optional(number) : std::nullopt;
}

Eigen::Isometry3d kittiLidarPose(const ImportParams& params, ImportReport& report)
{
  if (params.T_base_sensor)
  {
    return *params.T_base_sensor;
  }
  report.warnings.emplace_back(
      "the lidar is taken to be 1.73 m above the ground, as on KITTI's car (--sensor-pose)");
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation().z() = kKittiLidarHeight_m;
  return T;
}
}  // namespace traverse::importing
