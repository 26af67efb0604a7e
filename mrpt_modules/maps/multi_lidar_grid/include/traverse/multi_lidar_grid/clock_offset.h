// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/lattice.h>
#include <traverse/points/scan.h>
#include <traverse/poses/pose_track.h>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>

namespace traverse::multi_lidar_grid
{
/** Finds the constant offset of one sensor's clock against the poses while the vehicle moves: of
 * several offsets, the one with which the sensor's obstacles fall most often on those that other
 * sensors saw lately. */
class ClockOffset
{
 public:
  static constexpr int kSteps = 15;        //!< to either side
  static constexpr double kStep_s = 0.02;  //!< so offsets to 0.3 s are found

  /** Whether others saw an obstacle in a cell lately, nothing where they did not look. */
  using Seen = std::function<std::optional<bool>(geometry::CellIndex)>;

  /** Adds a deskewed scan's evidence: its points `low_m` to `high_m` over the vehicle's ground. */
  void add(
      const points::Scan& scan,
      const poses::PoseTrack& track,
      const geometry::Lattice& lattice,
      double low_m,
      double high_m,
      const Seen& others);

  /** s, to be added to the sensor's stamps; nothing as long as it is not clear. */
  std::optional<double> estimate_s() const;

 private:
  std::array<double, 2 * kSteps + 1> hits_{};  // weighted by how much an offset would show
  std::array<double, 2 * kSteps + 1> tries_{};
  uint32_t scans_ = 0;
};
}  // namespace traverse::multi_lidar_grid
