// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sources.h"

#include <traverse/importing/format.h>

#include <algorithm>
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

const Format* findFormat(std::string_view name)
{
  const auto all = allFormats();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Format& f) { return f.name == name; });
  return found == all.end() ? nullptr : &*found;
}

const Format* recogniseFormat(const std::filesystem::path& input)
{
  const auto all = allFormats();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Format& f) { return f.recognises(input); });
  return found == all.end() ? nullptr : &*found;
}
}  // namespace traverse::importing
