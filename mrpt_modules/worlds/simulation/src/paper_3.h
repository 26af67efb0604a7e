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
/** Free of things on either side of the vehicle's way, m. */
inline constexpr double kDriveFree_m = 1.5;

/** A random scene of style paper_3 in the making: the world of the paper on traversability grids,
 * a road through rolling fields with old snow. Each group of things has its own random numbers, so
 * that more trees do not move the walls. */
class Paper3
{
 public:
  /** Adds to `scene`, which must outlive it. */
  Paper3(SceneParams& scene, uint64_t seed);

  void addAll();

 private:
  Random randomFor(uint64_t purpose) const { return Random(mixed({seed_, purpose})); }

  // paper_3_ground.cpp
  void addGround();
  void addHills();
  void addRoad();
  void addKerb();
  void addDitch();
  void addBanks();
  void addBank(double from_m, double to_m, double side, Random& random);
  TerrainParams randomBank(Random& random) const;
  void addDrifts();
  void addRuts();
  void addRutsAside(Random& random, TerrainParams& ruts) const;
  double openSide(Random& random) const;

  // paper_3_things.cpp
  void addThings();
  void addBuildings();
  void addFencesAndWalls();
  void addLongThing(ObjectParams thing, Random& random);
  void addTrees();
  bool addOverhang(bool low, Random& random);
  bool addTree(ObjectParams tree, double along_m, double left_m, Random& random);
  void addBushes();
  void addPoles();
  void addStones();
  void addLumps();
  void addGrass();

  // paper_3_movers.cpp
  void addMovingVehicles();
  void addParkedVehicles();
  void addPeople();

  /** Adds the thing there, with a seed of its own. */
  void put(ObjectParams thing, const Eigen::Vector2d& at, Random& random);

  /** Adds something of that radius at a free place beside the road, where one is found. */
  void putSomewhere(ObjectParams thing, double radius_m, double farthest_m, Random& random);

  /** Takes the corners over, rounded. */
  void follow(TerrainParams& strip, double from_m, double to_m, double left_m) const;

  SceneParams& scene_;
  RandomSceneParams asks_;
  uint64_t seed_;
  Random first_;  //!< decides what several groups must know; draws in this order
  Way way_;
  Plot plot_;
  double half_road_m_;
  bool winter_;
  double kerb_side_ = 0;  //!< 1 left, -1 right, 0 none
  double ditch_side_ = 0;
  double lane_side_ = 0;  //!< on which vehicles drive, 0 where none do
  double lane_m_ = 0;     //!< how far beside the way's middle
  double kerb_m_ = 0;     //!< width of the pavement
};
}  // namespace traverse::simulation
