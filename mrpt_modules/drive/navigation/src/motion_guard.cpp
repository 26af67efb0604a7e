// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/geometry/frame2.h>
#include <traverse/navigation/grip.h>
#include <traverse/navigation/motion_guard.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace traverse::navigation
{
namespace
{
constexpr double kStep_m = 0.05;
constexpr double kStands_mps = 0.02;
constexpr double kTurnAhead_s = 0.4;

using Corner = Eigen::Vector2d;

/** The vehicle's frame after a way along an arc, seen from where it starts. */
geometry::Pose2 along(double way_m, double curvature_1pm)
{
  const double turn = way_m * curvature_1pm;
  const geometry::SinCos yaw = geometry::sinCosOfAny(turn);
  if (std::abs(turn) < 1e-6)
  {
    return {way_m, way_m * turn / 2, turn};
  }
  return {yaw.sin / curvature_1pm, (1 - yaw.cos) / curvature_1pm, turn};
}

Corner seenFrom(const geometry::Frame2& frame, const Eigen::Vector3f& point)
{
  return frame.in(point.head<2>().cast<double>());
}

/** Where the vehicle is on its way along an arc. */
struct Stage
{
  double way_m = 0;
  geometry::Frame2 frame;
};

/** Every kStep_m, up to most_m and one more. */
std::vector<Stage> stagesOf(const geometry::Twist2& arc, double most_m)
{
  const double curvature = arc.speed_mps == 0 ? 0 : arc.yaw_rate_radps / arc.speed_mps;
  const double side = arc.speed_mps < 0 ? -1 : 1;
  std::vector<Stage> stages;
  double way_m = kStep_m;
  while (way_m < most_m + kStep_m)
  {
    stages.push_back({way_m, geometry::Frame2::of(along(side * way_m, curvature))});
    way_m += kStep_m;
  }
  return stages;
}
}  // namespace

MotionGuard::MotionGuard(
    const geometry::Vehicle& vehicle,
    const geometry::Drivetrain& drivetrain,
    const GuardParams& params) :
    accel_mps2_(drivetrain.max_accel_mps2),
    brakes_mps2_(drivetrain.max_decel_mps2),
    decel_mps2_(brakes_mps2_),
    yaw_rate_radps_(drivetrain.max_yaw_rate_degps * geometry::kPi / 180),
    params_(params)
{
  options::check(params_);
  const geometry::Outline hull = geometry::convexHull(geometry::footprintOf(vehicle));
  if (hull.empty())
  {
    throw std::invalid_argument("a footprint without area");
  }
  for (size_t i = 0; i < hull.size(); ++i)
  {
    const Corner side = hull[(i + 1) % hull.size()] - hull[i];
    const Corner normal = Corner(side.y(), -side.x()) / side.norm();
    edges_.push_back({normal.x(), normal.y(), normal.dot(hull[i])});
    radius_m_ = std::max(radius_m_, hull[i].norm());
  }
}

void MotionGuard::standOn(double friction)
{
  decel_mps2_ = std::fmin(brakes_mps2_, friction * kGravity);  // NaN: the brakes'
}

double MotionGuard::depth_m(double x_m, double y_m) const
{
  double outside = -std::numeric_limits<double>::infinity();
  for (const Edge& edge : edges_)
  {
    outside = std::max(outside, edge.normal_x * x_m + edge.normal_y * y_m - edge.offset_m);
  }
  return -outside;
}

double MotionGuard::stopsWithin_m(double speed_mps) const
{
  const double speed = std::abs(speed_mps);
  return speed * params_.reaction_s + speed * speed / (2 * decel_mps2_);
}

double MotionGuard::freeWay_m(
    const geometry::Twist2& arc, std::span<const Eigen::Vector3f> obstacles, double most_m) const
{
  const std::vector<Stage> stages = stagesOf(arc, most_m);
  const double reach_m = most_m + radius_m_ + params_.margin_m;
  double free_m = most_m;
  for (const Eigen::Vector3f& point : obstacles)
  {
    if (std::max(std::abs(point.x()), std::abs(point.y())) > reach_m)
    {
      continue;
    }
    const double depth_now = depth_m(point.x(), point.y());
    const double allowed = std::max(-params_.margin_m, depth_now + 1e-3);
    for (const Stage& stage : stages)
    {
      const Corner then = seenFrom(stage.frame, point);
      if (stage.way_m >= free_m + kStep_m || depth_m(then.x(), then.y()) > allowed)
      {
        free_m = std::min(free_m, stage.way_m - kStep_m);
        break;
      }
    }
  }
  return free_m;
}

geometry::Twist2 MotionGuard::guarded(
    const geometry::Twist2& command,
    const geometry::Twist2& motion,
    std::span<const Eigen::Vector3f> obstacles) const
{
  if (std::abs(command.speed_mps) < kStands_mps)
  {
    // turning on the spot: the corners come round
    const double turn =
        std::clamp(command.yaw_rate_radps, -yaw_rate_radps_, yaw_rate_radps_) * kTurnAhead_s;
    const auto turned = geometry::Frame2::of(geometry::Pose2{0, 0, turn});
    const bool hits = std::any_of(
        obstacles.begin(), obstacles.end(),
        [&](const Eigen::Vector3f& point)
        {
          const Corner then = seenFrom(turned, point);
          return depth_m(then.x(), then.y()) > std::max(0.0, depth_m(point.x(), point.y()) + 1e-3);
        });
    return hits ? geometry::Twist2{} : command;
  }
  // what the command can make of the speed until it is heard of again
  const double faster = std::abs(motion.speed_mps) + accel_mps2_ * params_.reaction_s;
  const double speed = std::min(std::abs(command.speed_mps), faster);
  const double most_m = stopsWithin_m(std::max(speed, std::abs(motion.speed_mps))) + kStep_m;
  double free_m = freeWay_m(command, obstacles, most_m);
  const bool goes_on = motion.speed_mps * command.speed_mps > 0;
  if (goes_on && std::abs(motion.speed_mps) > kStands_mps)
  {
    free_m = std::min(free_m, freeWay_m(motion, obstacles, most_m));
  }
  if (free_m >= most_m - 1e-9)
  {
    return command;
  }
  // the speed from which it stops within free_m: v t + v^2 / 2a = s
  const double a = decel_mps2_;
  const double t = params_.reaction_s;
  const double most_mps = -a * t + std::sqrt(a * t * a * t + 2 * a * free_m);
  const double share = std::min(1.0, most_mps / std::abs(command.speed_mps));
  return {command.speed_mps * share, command.yaw_rate_radps * share};
}
}  // namespace traverse::navigation
