// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "embree_scene.h"

namespace traverse::simulation
{
/** A thing that moves, in a structure of its own: a ray is taken into the thing's frame at the
 * ray's own time. */
class MovingThing
{
 public:
  MovingThing(RTCDeviceTy* device, const Object& object, uint32_t number);

  /** As EmbreeScene::cast(), of the map frame, at a time. */
  bool cast(
      const Eigen::Vector3d& origin,
      const Eigen::Vector3d& direction,
      double t_s,
      double max_m,
      SoupHit& hit) const;

 private:
  /** A ball that holds the thing during a while. */
  struct Bound
  {
    Eigen::Vector3d centre;
    double radius_m;
  };

  static constexpr double kWhile_s = 0.1;

  Bound boundAround(double from_s) const;
  const Bound& boundAt(double t_s) const;

  Motion motion_;
  EmbreeScene scene_;
  double radius_m_ = 0;
  std::vector<Bound> bounds_;  // one for each while from the first pose to the last
};
}  // namespace traverse::simulation
