// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/sensors/velodyne_packet.h>
#include <traverse/simulation/lidar.h>
#include <traverse/simulation/random.h>

#include <vector>

namespace traverse::simulation
{
/** What a beam brings back. */
struct Measured
{
  sensors::VelodyneReturn record;  //!< distance 0: nothing
  ReturnTruth truth;
};

/** What of a beam's light is seen, its noise not yet made. */
struct Caught
{
  bool is_any = false;
  ReturnTruth truth;
  double range_m = 0;
  double intensity = 0;
  NormalDraw noise;
};

/** What a sensor makes of what its beams meet. */
class Receiver
{
 public:
  /** `biases_m`: what each laser measures too much. */
  Receiver(const LidarParams& params, const std::vector<double>& biases_m);

  double maxRangeMetres() const { return max_range_m_; }

  Caught receive(const Hit& hit, Random& random) const;

  /** `noise`: of Caught::noise. */
  Measured measure(size_t laser, const Caught& caught, double noise) const;

 private:
  bool isSeen(const Hit& hit, Random& random) const;
  NormalDraw drawNoise(Random& random) const;

  const std::vector<double>& biases_m_;
  double max_range_m_;
  double unit_m_;
  double noise_m_;
  double half_range_m_;
  double drop_out_;
  double rain_share_;
  bool last_;
};
}  // namespace traverse::simulation
