// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/points/scan.h>

#include <array>
#include <filesystem>
#include <stdexcept>
#include <support/labelled_clouds.h>

namespace traverse::bench
{
inline const std::filesystem::path kFolder =
    std::filesystem::path(TRAVERSE_DATA_DIR) / "nuscenes-hdl32-labelled";
inline const double kMount_m = testing::mountHeight_m(testing::Layout::nuscenes);

inline void require(bool holds, const char* what)
{
  if (!holds)
  {
    throw std::runtime_error(what);
  }
}

/** Two clouds, one after the other, so that no sensor seems stuck; on the ground's frame. */
inline const points::ScanBuffer& cloud(size_t i)
{
  static const std::array<points::ScanBuffer, 2> kClouds = []
  {
    std::array<points::ScanBuffer, 2> clouds;
    const auto files = testing::labelledFiles(testing::Layout::nuscenes, kFolder);
    for (size_t k = 0; k < clouds.size(); ++k)
    {
      clouds[k] =
          testing::readLabelled(testing::Layout::nuscenes, files.at(k).first, files.at(k).second)
              .scan;
      clouds[k].sensor_label = "roof";
      clouds[k].T_base_sensor.translation().z() = kMount_m;
      for (float& z : clouds[k].z)
      {
        z += static_cast<float>(kMount_m);
      }
    }
    return clouds;
  }();
  return kClouds[i % 2];
}
}  // namespace traverse::bench
