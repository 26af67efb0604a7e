// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/sensors/velodyne_packet.h>
#include <traverse/simulation/lidar.h>
#include <traverse/simulation/random.h>

namespace traverse::simulation
{
/** What a beam brings back. */
struct Measured
{
  sensors::VelodyneReturn record;  //!< distance 0: nothing
  ReturnTruth truth;
};

/** What a sensor makes of what its beams meet. */
class Receiver
{
 public:
  explicit Receiver(const LidarParams& params);

  double maxRangeMetres() const { return max_range_m_; }

  Measured measure(const Hit& hit, Random& random) const;

 private:
  bool isSeen(const Hit& hit, Random& random) const;
  Measured drop(double range_m, Random& random) const;
  Measured record(const ReturnTruth& truth, double range_m, double intensity, Random& random) const;

  double max_range_m_;
  double unit_m_;
  double noise_m_;
  double half_range_m_;
  double drop_out_;
  double rain_share_;
  bool last_;
};
}  // namespace traverse::simulation
