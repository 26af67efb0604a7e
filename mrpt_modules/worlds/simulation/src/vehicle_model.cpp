// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_planes.h"

#include <traverse/geometry/exact_trig.h>
#include <traverse/simulation/drive.h>
#include <traverse/simulation/vehicle_model.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace traverse::simulation
{
namespace
{
constexpr double kGravity = 9.81;  // m/s2
constexpr double kStep_s = kDriveStepSeconds;
constexpr double kRadians = geometry::kPi / 180;

/** The value, moved towards its aim by at most so much. */
double towards(double value, double aim, double most)
{
  return std::clamp(aim, value - most, value + most);
}

double wrapped(double angle_rad)
{
  return std::abs(angle_rad) <= geometry::kPi ? angle_rad
                                              : std::remainder(angle_rad, 2 * geometry::kPi);
}

/** Speed towards its aim; a vehicle brakes to zero before it goes the other way. */
double nextSpeed(double speed, double aim, const geometry::Drivetrain& drivetrain)
{
  const bool brakes = std::abs(aim) < std::abs(speed) || aim * speed < 0;
  const double next = towards(
      speed, aim, (brakes ? drivetrain.max_decel_mps2 : drivetrain.max_accel_mps2) * kStep_s);
  return next * speed < 0 ? 0 : next;
}

Eigen::Vector2d headingOf(double yaw_rad)
{
  const auto [s, c] = geometry::sinCosOf(yaw_rad);
  return {c, s};
}

Eigen::Vector2d leftOf(const Eigen::Vector2d& heading)
{
  return {-heading.y(), heading.x()};
}

SmoothLine::Place placeOf(const geometry::Pose2& pose)
{
  return {{pose.x_m, pose.y_m}, headingOf(pose.yaw_rad)};
}

/** The mean over 0.6 m of the way before and behind, twice over: weights of a triangle. */
WheelPlane smoothPlane(const Terrain& terrain, const Wheels& wheels, const SmoothLine::Place& place)
{
  constexpr int kReach = 4;
  constexpr double kApart_m = 0.15;
  std::array<double, 4> sum{};
  for (int i = -kReach + 1; i < kReach; ++i)
  {
    const double weight = static_cast<double>(kReach - std::abs(i)) / (kReach * kReach);
    const std::array<double, 4> z =
        wheels.heights(terrain, {place.p + i * kApart_m * place.heading, place.heading});
    for (size_t wheel = 0; wheel < sum.size(); ++wheel)
    {
      sum[wheel] += weight * z[wheel];
    }
  }
  return wheels.planeOf(sum);
}
}  // namespace

VehicleModel::VehicleModel(
    std::shared_ptr<const Terrain> terrain,
    const geometry::Vehicle& vehicle,
    const geometry::Drivetrain& drivetrain,
    const geometry::Pose2& start) :
    terrain_(std::move(terrain)), vehicle_(vehicle), drivetrain_(drivetrain)
{
  if (!terrain_)
  {
    throw std::invalid_argument("a vehicle needs ground to drive on");
  }
  if (!std::isfinite(start.x_m) || !std::isfinite(start.y_m) || !std::isfinite(start.yaw_rad))
  {
    throw std::invalid_argument("the vehicle's start is no number");
  }
  options::check(vehicle);
  options::check(drivetrain);
  const Wheels wheels(vehicle);
  const Eigen::Vector2d diagonal(wheels.front_m - wheels.rear_m, wheels.left_m - wheels.right_m);
  corner_m_ = std::sqrt(diagonal.dot(diagonal)) / 2;
  state_.pose = {start.x_m, start.y_m, wrapped(start.yaw_rad)};
  stand();
}

void VehicleModel::step(const geometry::Twist2& command, double dt_s)
{
  constexpr double kMost_s = 60;
  constexpr double kRounding_s = 1e-9;
  const bool numbers = std::isfinite(command.speed_mps) && std::isfinite(command.yaw_rate_radps);
  if (!numbers || !(dt_s > 0) || dt_s > kMost_s)
  {
    throw std::invalid_argument(
        "a step of a vehicle takes 0 to 60 s, and a command that is a number");
  }
  owed_s_ += dt_s;
  while (owed_s_ >= kStep_s - kRounding_s)
  {
    owed_s_ -= kStep_s;
    stepOnce(command);
  }
}

void VehicleModel::stepOnce(const geometry::Twist2& command)
{
  ++steps_;
  state_.t_s = static_cast<double>(steps_) / 100;
  turnWheels(command);
  follow();
  stand();
}

void VehicleModel::turnWheels(const geometry::Twist2& command)
{
  geometry::Twist2& wheels = state_.wheels;
  const double speed =
      std::clamp(command.speed_mps, -drivetrain_.max_reverse_mps, drivetrain_.max_speed_mps);
  wheels.speed_mps = nextSpeed(wheels.speed_mps, speed, drivetrain_);
  if (drivetrain_.steering == geometry::Steering::differential)
  {
    const double most = drivetrain_.max_yaw_rate_degps * kRadians;
    wheels.yaw_rate_radps = towards(
        wheels.yaw_rate_radps, std::clamp(command.yaw_rate_radps, -most, most),
        drivetrain_.max_yaw_accel_degps2 * kRadians * kStep_s);
    return;
  }
  constexpr double kStands_mps = 1e-6;
  if (std::abs(command.speed_mps) > kStands_mps)
  {
    // bicycle: tan(steer) = wheelbase * yaw rate / speed
    const double back = command.speed_mps < 0 ? -1 : 1;
    const double wanted = geometry::angleOf(
        back * drivetrain_.wheelbase_m * command.yaw_rate_radps, back * command.speed_mps);
    const double most = drivetrain_.max_steer_deg * kRadians;
    state_.steer_rad = towards(
        state_.steer_rad, std::clamp(wanted, -most, most),
        drivetrain_.max_steer_rate_degps * kRadians * kStep_s);
  }
  wheels.yaw_rate_radps =
      wheels.speed_mps * geometry::tangentOf(state_.steer_rad) / drivetrain_.wheelbase_m;
}

void VehicleModel::follow()
{
  // velocities along the ground, in axes of the map as seen from above
  const double turn_before = state_.twist.yaw_rate_radps;
  const Eigen::Vector2d heading = headingOf(state_.pose.yaw_rad);
  const Eigen::Vector2d velocity =
      state_.twist.speed_mps * heading + state_.aside_mps * leftOf(heading);
  const double turn_wanted = state_.wheels.yaw_rate_radps;
  const double yaw_wanted = state_.pose.yaw_rad + (turn_before + turn_wanted) / 2 * kStep_s;
  Eigen::Vector2d push = (state_.wheels.speed_mps * headingOf(yaw_wanted) - velocity) / kStep_s;
  double twist = (turn_wanted - turn_before) / kStep_s;

  // what the tyres must give: the wanted acceleration, and what holds the vehicle on its slope
  const double upright =
      1 / std::sqrt(1 + ground_.forward * ground_.forward + ground_.left * ground_.left);
  const Eigen::Vector2d downhill =
      -kGravity * upright * (ground_.forward * heading + ground_.left * leftOf(heading));
  const Eigen::Vector2d grip = push - downhill;
  const double asked = std::sqrt(grip.dot(grip) + corner_m_ * corner_m_ * twist * twist);
  const double given = ground_.friction * kGravity * upright;
  state_.slips = asked > given;
  if (state_.slips)
  {
    const double share = given / asked;
    push = share * grip + downhill;
    twist = share * twist;
  }

  const Eigen::Vector2d after = velocity + push * kStep_s;
  const double turn_after = state_.slips ? turn_before + twist * kStep_s : turn_wanted;
  const double yaw = state_.pose.yaw_rad + (turn_before + turn_after) / 2 * kStep_s;
  const Eigen::Vector2d way = (velocity + after) / 2 * kStep_s;
  const double ahead = way.dot(heading) / std::sqrt(1 + ground_.forward * ground_.forward);
  const double aside = way.dot(leftOf(heading)) / std::sqrt(1 + ground_.left * ground_.left);
  const Eigen::Vector2d moved = ahead * heading + aside * leftOf(heading);
  state_.pose = {state_.pose.x_m + moved.x(), state_.pose.y_m + moved.y(), wrapped(yaw)};

  const Eigen::Vector2d now = headingOf(yaw);
  state_.twist.yaw_rate_radps = turn_after;
  state_.twist.speed_mps = state_.slips ? after.dot(now) : state_.wheels.speed_mps;
  state_.aside_mps = state_.slips ? after.dot(leftOf(now)) : 0;
}

void VehicleModel::stand()
{
  const Wheels wheels(vehicle_);
  const SmoothLine::Place place = placeOf(state_.pose);
  const WheelPlane plane = smoothPlane(*terrain_, wheels, place);
  ground_ = {plane.forward, plane.left, 0};
  for (const Eigen::Vector2d& corner : wheels.corners())
  {
    const Eigen::Vector2d at = Wheels::onMap(place, corner);
    ground_.friction += frictionOf(terrain_->at(at.x(), at.y()).material) / 4;
  }
  constexpr auto kKept = static_cast<size_t>(kKept_s / kStep_s) + 1;
  if (track_.size() >= 2 * kKept)
  {
    track_.erase(track_.begin(), track_.end() - static_cast<ptrdiff_t>(kKept));
  }
  track_.push_back({state_.t_s, standing(place, plane, vehicle_.base_height_m)});
}

Motion VehicleModel::recent(double seconds) const
{
  const double wanted = std::ceil(std::clamp(seconds, 0.0, kKept_s) / kStep_s) + 1;
  const size_t count = std::min(track_.size(), static_cast<size_t>(wanted));
  return Motion({track_.end() - static_cast<ptrdiff_t>(count), track_.end()});
}
}  // namespace traverse::simulation
