// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/drivetrain.h>
#include <traverse/geometry/pose2.h>
#include <traverse/geometry/vehicle.h>
#include <traverse/simulation/motion.h>
#include <traverse/simulation/scene.h>

#include <Eigen/Geometry>

#include <memory>
#include <vector>

namespace traverse::simulation
{
/** Where a vehicle is and how it moves. */
struct VehicleState
{
  double t_s = 0;  //!< of the scene
  geometry::Pose2 pose;
  geometry::Twist2 twist;   //!< over the ground
  geometry::Twist2 wheels;  //!< as the wheels turn: what odometry sees
  double steer_rad = 0;     //!< ackermann: of the front wheels, left positive
  bool slips = false;       //!< the wheels want more than friction gives
};

/** Coefficient of friction between tyre and surface, by material; ice 0.1, tarmac 0.8 ... with
 * sources. */
double frictionOf(Material material);

/** A vehicle on the ground of a scene. Its wheels follow the commanded speed and turn as fast as
 * accelerations, steering rate and steering limits let them; the vehicle follows its wheels as far
 * as the sum of longitudinal and lateral acceleration stays below mu g of the surface under it
 * (less the slope's part), and slides on with what it had beyond that. Steps of 10 ms inside. The
 * same bits everywhere. */
class VehicleModel
{
 public:
  VehicleModel(
      std::shared_ptr<const Terrain> terrain,
      const geometry::Vehicle& vehicle,
      const geometry::Drivetrain& drivetrain,
      const geometry::Pose2& start);

  /** Drives on for dt_s (> 0) under one command. */
  void step(const geometry::Twist2& command, double dt_s);

  const VehicleState& state() const { return state_; }

  /** T_map_base on the ground: height, roll and pitch of the plane under the footprint. */
  Eigen::Isometry3d T_map_base() const;

  /** Poses of the last seconds, every 10 ms, for sensors that turn while it drives. */
  Motion recent(double seconds) const;

 private:
  void stepOnce(const geometry::Twist2& command);

  std::shared_ptr<const Terrain> terrain_;
  geometry::Vehicle vehicle_;
  geometry::Drivetrain drivetrain_;
  VehicleState state_;
  std::vector<TimedPose> track_;
};

/** Distance from the vehicle's outline at a pose to the nearest thing that it must not touch:
 * footprints of objects at time t_s lower than its height (grass and what its wheels take excepted)
 * and ditches or holes deeper than a step; negative: how far inside. Up to most_m. */
class Surroundings
{
 public:
  Surroundings(const Scene& scene, const geometry::Vehicle& vehicle);

  double clearance_m(const geometry::Pose2& pose, double t_s, double most_m) const;

 private:
  struct Thing;
  std::vector<std::shared_ptr<const Thing>> things_;
  std::shared_ptr<const Terrain> terrain_;
  geometry::Vehicle vehicle_;
};
}  // namespace traverse::simulation
