// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "random_draws.h"
#include "random_plot.h"

#include <traverse/simulation/random.h>
#include <traverse/simulation/scene_params.h>

#include <cmath>

namespace traverse::simulation
{
/** A random scene of style paper_5 in the making: a winding street with traffic in both directions,
 * parked cars, people, walls and houses beside it, bridges and beams over it, ditches and holes.
 * Nothing is between 13 and 35 cm high, and ditches end, so that there is a way around them. */
class Paper5
{
 public:
  /** Adds to `scene`, which must outlive it. */
  Paper5(SceneParams& scene, uint64_t seed);

  void addAll();

 private:
  Random randomFor(uint64_t purpose) const { return Random(mixed({seed_, purpose})); }

  // paper_5.cpp
  void addGround();
  void addDitches();
  void addHoles();
  void addOverhangs();

  // paper_5_things.cpp
  void addTraffic();
  void addColumn(double side, double from_m, double gap_m, double way_m, double speed_mps, int n);
  void addParkedVehicles();
  void addBuildings();
  void addWalls();
  void addSmallThings();
  void addPeople();

  /** Adds the thing there. */
  void put(ObjectParams thing, const Eigen::Vector2d& at);

  /** Adds the thing beside the road, `radius_m` around it free, where a place is found. */
  void putSomewhere(ObjectParams thing, double radius_m, double farthest_m, Random& random);

  /** Somewhere along the drive. */
  double anywhere(Random& random) const { return random.uniform(-half_m_, half_m_); }

  static double side(Random& random) { return random.chance(0.5) ? 1 : -1; }

  SceneParams& scene_;
  RandomSceneParams asks_;
  uint64_t seed_;
  double half_m_;  //!< of the drive
  Way way_;
  Plot plot_;
  double half_road_m_ = 0;
};
}  // namespace traverse::simulation
