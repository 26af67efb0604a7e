// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "entries.h"
#include "folders.h"
#include "planned_source.h"

#include <functional>
#include <optional>
#include <vector>

namespace traverse::importing
{
/** Height of the Velodyne of KITTI's car above the ground, m (of the recording's set-up page). */
inline constexpr double kKittiLidarHeight_m = 1.73;

/** One rectified camera of KITTI. */
struct KittiCamera
{
  Camera pinhole;
  Eigen::Isometry3d T_cam0_camera = Eigen::Isometry3d::Identity();
};

/** Of a projection matrix of 12 numbers; nothing where there is none or it makes no sense. */
std::optional<KittiCamera> kittiCamera(const std::vector<double>& projection);

/** The pictures of one camera. */
struct KittiPictures
{
  std::filesystem::path folder;
  std::string label;
  Eigen::Isometry3d T_base_camera = Eigen::Isometry3d::Identity();
  Camera pinhole;
};

/** One step for each picture; `stamp_of` gives a picture's time from its place in the folder. */
void addPictures(
    const KittiPictures& pictures,
    const std::function<std::optional<poses::TimeNs>(const std::filesystem::path&, size_t)>&
        stamp_of,
    std::vector<Step>& steps);

/** The number that a file is named by; nothing for other names. */
std::optional<size_t> frameNumber(const std::filesystem::path& file);

/** Takes points of the lidar to the vehicle: what was asked for, or KITTI's car. */
Eigen::Isometry3d kittiLidarPose(const ImportParams& params, ImportReport& report);
}  // namespace traverse::importing
