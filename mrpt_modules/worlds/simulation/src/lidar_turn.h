// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lidar_firings.h"
#include "lidar_return.h"

#include <traverse/sensors/velodyne_encode.h>
#include <traverse/simulation/lidar.h>

#include <vector>

namespace traverse::simulation
{
/** Fires one packet after the other. */
class PacketMaker
{
 public:
  struct World
  {
    const RayCaster& scene;
    const Motion& drive;
    const std::vector<double>& biases_m;  //!< of the lasers
  };

  /** Times below are of the recording; `turn_begin_ns`: when the encoder is at phase_deg. */
  PacketMaker(const LidarParams& params, const World& world, int64_t turn_ns, int64_t begin_ns);

  /** Adds the truth of the packet's returns to `truth`. */
  sensors::VelodynePacketContent make(
      int64_t start_ns, Random& random, std::vector<ReturnTruth>& truth);

 private:
  void fireSequence(
      int64_t start_ns,
      Random& random,
      sensors::VelodyneReturn* records,
      std::vector<ReturnTruth>& truth);
  Eigen::Isometry3d sensorPose(int64_t time_ns) const;
  MovingPlacement placementFrom(int64_t start_ns);

  const LidarParams& params_;
  World world_;
  sensors::VelodyneTiming timing_;
  std::vector<SimulatedLaser> lasers_;
  Encoder encoder_;
  Receiver receiver_;
  Eigen::Isometry3d T_base_sensor_;
  int64_t begin_ns_;
  int64_t last_pose_ns_;
  Eigen::Isometry3d last_pose_;
};

/** Where a lidar sits. */
Eigen::Isometry3d placeOf(const LidarParams& params);
}  // namespace traverse::simulation
