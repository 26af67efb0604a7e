// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/drivetrain.h>
#include <traverse/geometry/pose2.h>
#include <traverse/geometry/vehicle.h>
#include <traverse/simulation/motion.h>
#include <traverse/simulation/scene.h>

#include <Eigen/Geometry>

#include <cstdint>
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
  double aside_mps = 0;     //!< how fast it slides to its left
  geometry::Twist2 wheels;  //!< as the wheels turn: what odometry sees
  double steer_rad = 0;     //!< ackermann: of the front wheels, left positive
  bool slips = false;       //!< the wheels want more than friction gives
};

/** Coefficient of friction between a rolling tyre and a surface, 1: the peak values of M. G.
 * Bekker's and J. Y. Wong's tables (Theory of Ground Vehicles, "coefficient of road adhesion":
 * asphalt and concrete 0.8, dry earth 0.68, hard snow 0.2, ice 0.1); those of what is no road are
 * guesses. */
double frictionOf(Material material);

/** A vehicle on the ground of a scene. Its wheels follow the commanded speed and turn as fast as
 * accelerations, steering rate and steering limits let them; the vehicle follows its wheels as far
 * as the sum of longitudinal and lateral acceleration of its frame's origin stays below mu g of the
 * surface under its wheels (less the slope's part), and slides on with what it had beyond that; how
 * fast its turning changes counts as the acceleration of a footprint's corner. Mass does not count:
 * weight and inertia grow alike. Steps of 10 ms inside. The same bits everywhere. */
class VehicleModel
{
 public:
  /** Stands at `start`, t = 0. Throws std::invalid_argument for no terrain, a footprint without
   * area, or a start that is no number; options::OptionError. */
  VehicleModel(
      std::shared_ptr<const Terrain> terrain,
      const geometry::Vehicle& vehicle,
      const geometry::Drivetrain& drivetrain,
      const geometry::Pose2& start);

  /** Drives on for dt_s (> 0, what is left of 10 ms waits for the next step) under one command; a
   * car whose command is to turn without speed leaves its steering as it is. Throws
   * std::invalid_argument for what is no number, or more than a minute. */
  void step(const geometry::Twist2& command, double dt_s);

  const VehicleState& state() const { return state_; }

  /** T_map_base on the ground: height, roll and pitch of the plane under the footprint, smoothed
   * over 0.6 m before and behind as driveOn() does. */
  Eigen::Isometry3d T_map_base() const  // NOLINT(readability-identifier-naming)
  {
    return track_.back().T_map_body;
  }

  /** Poses of the last seconds (at most kKept_s), every 10 ms, for sensors that turn while it
   * drives. */
  Motion recent(double seconds) const;

  static constexpr double kKept_s = 20;

 private:
  /** Of the ground that carries it. */
  struct Ground
  {
    double forward = 0;  //!< slope
    double left = 0;
    double friction = 0;
  };

  void stepOnce(const geometry::Twist2& command);
  void turnWheels(const geometry::Twist2& command);
  void follow();
  void stand();

  std::shared_ptr<const Terrain> terrain_;
  geometry::Vehicle vehicle_;
  geometry::Drivetrain drivetrain_;
  VehicleState state_;
  Ground ground_;
  double corner_m_ = 0;  //!< from the footprint's middle to its corners
  double owed_s_ = 0;    //!< of step(), not yet driven
  int64_t steps_ = 0;
  std::vector<TimedPose> track_;
};
}  // namespace traverse::simulation
