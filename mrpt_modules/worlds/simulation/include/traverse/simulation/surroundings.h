// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/pose2.h>
#include <traverse/geometry/vehicle.h>
#include <traverse/simulation/scene.h>

#include <memory>

namespace traverse::simulation
{
/** What a vehicle must not touch: footprints() of things that stand higher than a step over the
 * ground (grass, and what hangs above the vehicle, excepted), and ditches and holes deeper than a
 * step. Things that move keep the outline that they have at the scene's beginning. */
class Surroundings
{
 public:
  /** Throws as footprints(), and std::invalid_argument where the vehicle's outline has no area. */
  Surroundings(const Scene& scene, const geometry::Vehicle& vehicle);

  /** Distance from the vehicle's outline at a pose to the nearest of them at time t_s, m; negative:
   * how far it would have to be moved to be free of one, at least. Up to most_m. Ditches are known
   * to 5 cm. Fast: some microseconds. */
  double clearance_m(const geometry::Pose2& pose, double t_s, double most_m) const;

 private:
  struct Known;
  std::shared_ptr<const Known> known_;
};
}  // namespace traverse::simulation
