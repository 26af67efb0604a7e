// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/points/scan.h>
#include <traverse/poses/pose_track.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace traverse::multi_lidar_grid
{
/** Finds the constant offset of one sensor's clock against the poses, from that sensor alone.
 *
 * Upright things that a vehicle passes are met again some seconds later. With the right offset both
 * clouds have them at one place; with a wrong one each is misplaced by the vehicle's velocity then,
 * which shows as soon as the vehicle has turned or changed its speed in between. Of kOffsets
 * offsets the one counts with which the points of the later clouds fall nearest to those of the
 * earlier ones. At a steady speed straight on nothing shows, and nothing is added; after kMostPairs
 * pairs of clouds it is known. */
class ClockOffset
{
 public:
  static constexpr int kSteps = 15;  //!< to either side of 0
  static constexpr int kOffsets = 2 * kSteps + 1;
  static constexpr double kStep_s = 0.02;  //!< so offsets to 0.3 s are found
  static constexpr int kMostPairs = 200;

  /** Takes a deskewed scan, by its own clock's stamp; most of them only to look whether it is time
   * for another key cloud. Upright is what stands low_m to high_m over the vehicle frame's origin.
   */
  void add(const points::Scan& scan, const poses::PoseTrack& track, double low_m, double high_m);

  /** s, to be added to the sensor's stamps; nothing as long as it is not clear. */
  std::optional<double> estimate_s() const;

 private:
  /** An earlier cloud, thinned out. */
  struct Key
  {
    poses::TimeNs stamp = 0;
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  // m/s, map frame
    std::vector<Eigen::Vector3d> p_base;
    std::vector<uint8_t> near;  // grid of the vehicle's surroundings: how near a point is
  };

  void compare(const Key& earlier, const Key& later, const poses::PoseTrack& track);

  std::deque<Key> keys_;
  std::array<double, kOffsets> score_{};  // sums over pairs of clouds: how well points match
  int pairs_ = 0;
};
}  // namespace traverse::multi_lidar_grid
