// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/drivetrain.h>
#include <traverse/geometry/pose2.h>
#include <traverse/geometry/vehicle.h>
#include <traverse/options/option.h>

#include <Eigen/Core>

#include <concepts>
#include <span>
#include <type_traits>
#include <vector>

namespace traverse::navigation
{
/** Section [Guard]. */
struct GuardParams
{
  double margin_m = 0.1;
  double reaction_s = 0.1;

  friend bool operator==(const GuardParams&, const GuardParams&) = default;
};

template <class P, class F>
requires std::same_as<std::remove_const_t<P>, GuardParams>

void visit(P& p, F&& f)
{
  using options::Option;
  f(Option{"margin_m", "the outline stops so far from obstacles, m", {0, 5}}, p.margin_m);
  f(Option{"reaction_s", "from a command to the brakes, s", {0, 5}}, p.reaction_s);
}

/** Lets commands pass that the vehicle can still brake before it touches anything, and slows others
 * down along the same arc, to a stand if need be: what a reactive layer that thinks in trajectories
 * without inertia does not see. */
class MotionGuard
{
 public:
  /** Throws std::invalid_argument where the footprint has no area,
   * options::OptionError. */
  MotionGuard(
      const geometry::Vehicle& vehicle,
      const geometry::Drivetrain& drivetrain,
      const GuardParams& params);

  /** Brakes by no more than this friction from now on; NaN: by what the vehicle's brakes give. Of
   * ground that it comes to while it brakes the guard knows nothing. */
  void standOn(double friction);

  /** Obstacles are points of the vehicle frame. A vehicle that moves is held against the arc that
   * it drives and the arc that it is told to drive; both must be free as far as it takes to stop.
   * What is within the margin already hinders only motion that comes nearer. */
  geometry::Twist2 guarded(
      const geometry::Twist2& command,
      const geometry::Twist2& motion,
      std::span<const Eigen::Vector3f> obstacles) const;

  /** How far the outline (with its margin) gets along an arc before it touches something, m, up to
   * most_m; backward where speed is negative. */
  double freeWay_m(
      const geometry::Twist2& arc, std::span<const Eigen::Vector3f> obstacles, double most_m) const;

 private:
  double depth_m(double x_m, double y_m) const;
  double stopsWithin_m(double speed_mps) const;

  struct Edge
  {
    double normal_x = 0;  // outward
    double normal_y = 0;
    double offset_m = 0;
  };

  std::vector<Edge> edges_;  // of the footprint's convex hull
  double radius_m_ = 0;
  double accel_mps2_;
  double brakes_mps2_;
  double decel_mps2_;  // of the brakes, as far as the ground takes it
  double yaw_rate_radps_;
  GuardParams params_;
};
}  // namespace traverse::navigation
