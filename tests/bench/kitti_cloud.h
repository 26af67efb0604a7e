// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/points/scan.h>

#include <Eigen/Geometry>

#include <array>
#include <filesystem>
#include <stdexcept>
#include <zlib.h>

namespace traverse::bench
{
constexpr double kHalf_m = 75;
const std::filesystem::path kCloud =
    std::filesystem::path(TRAVERSE_DATA_DIR) / "kitti-odo00-labelled/full_resolution/000000.bin.gz";

inline void require(bool holds, const char* what)
{
  if (!holds)
  {
    throw std::runtime_error(what);
  }
}

inline points::ScanBuffer readCloud()
{
  points::ScanBuffer scan;
  gzFile in = gzopen(kCloud.c_str(), "rb");
  std::array<float, 4> p{};
  while (in != nullptr && gzread(in, p.data(), sizeof p) == static_cast<int>(sizeof p))
  {
    scan.x.push_back(p[0]);
    scan.y.push_back(p[1]);
    scan.z.push_back(p[2]);
  }
  gzclose(in);
  require(scan.size() > 120'000, "the cloud's size");
  return scan;
}

inline const points::ScanBuffer& cloud()
{
  static const points::ScanBuffer kScan = readCloud();
  return kScan;
}

/** A pose of no round numbers, so that nothing is saved. */
inline Eigen::Isometry3d at(double x)
{
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = (Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()) *
                Eigen::AngleAxisd(0.01, Eigen::Vector3d::UnitX()))
                   .toRotationMatrix();
  T.translation() = Eigen::Vector3d(x + 0.123, 0.456, 1.73);
  return T;
}
}  // namespace traverse::bench
