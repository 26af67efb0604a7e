// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pose_feed.h"

#include <traverse/nav_app/closed_loop.h>
#include <traverse/simulation/lidar.h>
#include <traverse/simulation/ray_caster.h>
#include <traverse/simulation/surroundings.h>

#include <vector>

namespace traverse::app
{
/** The vehicle and its lidars in a scene whose time goes on in control steps. */
class RobotWorld
{
 public:
  RobotWorld(const NavSettings& settings, const Mission& mission, uint64_t seed);

  /** The vehicle drives on under a command. */
  void drive(const geometry::Twist2& command, double dt_s);

  /** The turns that came in since the last call, by arrival. */
  std::vector<simulation::LidarTurn> arrived();

  double t_s() const { return vehicle_.state().t_s; }

  poses::TimeNs now() const;

  poses::StampedPose truth() const { return {now(), vehicle_.T_map_base()}; }

  const simulation::VehicleState& state() const { return vehicle_.state(); }

  double clearance_m() const;

 private:
  simulation::RayCaster caster_;
  simulation::Surroundings surroundings_;
  simulation::VehicleModel vehicle_;
  std::vector<simulation::Lidar> lidars_;
  std::vector<uint64_t> next_turns_;
};
}  // namespace traverse::app
