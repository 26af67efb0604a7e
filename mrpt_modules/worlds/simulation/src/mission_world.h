// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "free_grid.h"
#include "random_draws.h"

#include <traverse/simulation/random.h>
#include <traverse/simulation/scene_params.h>

#include <vector>

namespace traverse::simulation
{
/** A random world for a navigator in the making: an area within a wall, a mission, and things that
 * are only put where a vehicle 0.8 m wide still gets from goal to goal with 0.3 m to spare. */
class MissionWorld
{
 public:
  static constexpr double kVehicleHalf_m = 0.4;
  static constexpr double kSpare_m = 0.3;

  /** Adds to `scene`, which must outlive it. Throws OptionError where the area is not at least as
   * large as needed. */
  MissionWorld(SceneParams& scene, uint64_t seed, const Eigen::Vector2d& least_m);

  /** Numbers for one purpose, so that others may change without these. */
  Random randomFor(uint64_t purpose) const { return Random(mixed({seed_, purpose})); }

  /** A wall all around, this far inside the ground's end. */
  void addBorder(double height_m);

  /** Fine uneven ground everywhere. */
  void addRoughness();

  void addTerrain(const TerrainParams& piece) { scene_.terrains.push_back(piece); }

  /** Start and goals; the start looks to the first goal unless it is told where to. Round them
   * nothing is put. */
  void setMission(const std::vector<Eigen::Vector2d>& places);

  void lookTo(double yaw_deg) { scene_.mission.start_yaw_deg = inMillimetres(yaw_deg); }

  /** Puts a thing there whatever there is. */
  void put(ObjectParams thing, const std::vector<Stand>& stands);

  /** Puts it there if that is free (with gap_m to other things) and leaves a way; true if so. */
  bool putIfFree(ObjectParams thing, const Stand& stand, double gap_m);

  /** Ground that must not be driven on; false where it would leave no way. */
  bool block(const std::vector<Stand>& stands);

  /** Not to be built upon, but to be driven on. */
  void keepClear(const Stand& stand) { clear_.push_back(stand); }

  /** The way along the mission over free ground: [Drive]. */
  void proposeDrive();

  const SceneExtentParams& area() const { return scene_.extent; }

  const RandomSceneParams& asks() const { return asks_; }

  SceneParams& scene() { return scene_; }

 private:
  bool leavesAWay(const FreeGrid& grid);
  bool isFree(const Stand& stand, double gap_m) const;

  SceneParams& scene_;
  RandomSceneParams asks_;
  uint64_t seed_;
  FreeGrid grid_;
  std::vector<Stand> taken_;
  std::vector<Stand> clear_;
  std::vector<Eigen::Vector2d> places_;             // start and goals
  std::vector<std::vector<Eigen::Vector2d>> ways_;  // from each to the next, as last looked for
};

/** x_m, y_m and yaw_deg of a thing that stands there. */
ObjectParams standingAt(ObjectParams thing, const Eigen::Vector2d& at, double yaw_deg);

/** A rectangle of the thing's length and width around its middle. */
Stand boxStand(const ObjectParams& thing);

/** A wall between two places, m; its stand is lineBetween(). */
ObjectParams wallBetween(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double height_m);

/** Of a wall. */
inline constexpr double kWall_m = 0.25;

// The worlds themselves: RandomStyle of the same name.
void addClutter(SceneParams& scene, uint64_t seed);
void addPark(SceneParams& scene, uint64_t seed);
void addTunnel(SceneParams& scene, uint64_t seed);
void addWarehouse(SceneParams& scene, uint64_t seed);
void addIcyLot(SceneParams& scene, uint64_t seed);
}  // namespace traverse::simulation
