// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sources.h"

#include <traverse/importing/format.h>

#include <array>

namespace traverse::importing
{
std::span<const Format> allFormats()
{
  static const std::array kAll = {
      Format{"kitti-odometry", "a sequence of KITTI odometry", isKittiOdometry, openKittiOdometry},
      Format{"kitti-raw", "a drive of KITTI raw data", isKittiRaw, openKittiRaw},
      Format{"argoverse2", "an Argoverse 2 log as CSV", isArgoverse2, openArgoverse2},
      Format{"tum-rgbd", "an RGB-D folder of the TUM benchmark", isTumRgbd, openTumRgbd},
      Format{"7-scenes", "an RGB-D folder as of 7-Scenes", isSevenScenes, openSevenScenes},
      Format{"pcap", "a capture of Velodyne packets", isPcap, openPcap},
      Format{"clouds", "PCD, PLY, KITTI .bin or CSV clouds", isClouds, openClouds},
  };
  return kAll;
}
}  // namespace traverse::importing
