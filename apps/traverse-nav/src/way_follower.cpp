// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/nav_app/way_follower.h>
#include <traverse/navigation/on_path.h>
#include <traverse/navigation/track_path.h>

#include <algorithm>
#include <cmath>

namespace traverse::app
{
namespace
{
geometry::Drivetrain forwardOnly(geometry::Drivetrain drivetrain)
{
  drivetrain.max_reverse_mps = 0;
  return drivetrain;
}

/** So near its end a piece is over. */
constexpr double kOver_m = 0.06;

/** Slower than this the way's own arcs are as good as blocked, and the reactive layer looks for
 * others for a while. */
constexpr double kBlocked_mps = 0.1;
constexpr double kAround_s = 1;
}  // namespace

WayFollower::WayFollower(
    const FollowerParams& params,
    const std::filesystem::path& cache,
    const std::filesystem::path& log_folder) :
    params_(params),
    forward_(params.vehicle, forwardOnly(params.drivetrain), params.reactive, cache, log_folder)
{
  const geometry::Drivetrain& drivetrain = params.drivetrain;
  if (drivetrain.steering == geometry::Steering::ackermann && drivetrain.max_reverse_mps > 0)
  {
    backward_ = std::make_unique<reactive::ReactiveDriver>(
        params.vehicle, drivetrain, params.reactive, cache);
  }
}

reactive::ReactiveDriver& WayFollower::driver()
{
  const bool is_backward = !path_.empty() && path_[first_].is_backward;
  return is_backward && backward_ ? *backward_ : forward_;
}

std::span<const navigation::PathPoint> WayFollower::piece() const
{
  return std::span(path_).subspan(first_, last_ - first_ + 1);
}

navigation::OnPath WayFollower::placeOnPiece(const geometry::Pose2& pose) const
{
  return navigation::nearestOn(piece(), {pose.x_m, pose.y_m});
}

void WayFollower::beginPiece(size_t first, const geometry::Pose2& pose)
{
  driver().follow({});
  first_ = first;
  last_ = first + 1;
  while (last_ + 1 < path_.size() && path_[last_].is_backward == path_[first].is_backward)
  {
    ++last_;
  }
  std::vector<Eigen::Vector2d> places;
  const double from_m = placeOnPiece(pose).along_m;
  double next_m = params_.reactive.waypoint_spacing_m;
  for (size_t i = first_; i <= last_; ++i)
  {
    if (path_[i].along_m - from_m >= next_m || i == last_)
    {
      places.emplace_back(path_[i].pose.x_m, path_[i].pose.y_m);
      next_m = path_[i].along_m - from_m + params_.reactive.waypoint_spacing_m;
    }
  }
  driver().follow(places);
}

void WayFollower::follow(const navigation::Path& path, const geometry::Pose2& pose)
{
  driver().follow({});
  path_ = path;
  first_ = 0;
  last_ = 0;
  if (path_.size() > 1)
  {
    beginPiece(0, pose);
  }
}

navigation::SpeedLimit WayFollower::limitAt(
    const geometry::Pose2& pose,
    const geometry::Twist2& motion,
    const navigation::Costmap& costmap) const
{
  if (path_.empty())
  {
    return {0, navigation::SpeedReason::end};
  }
  const navigation::OnPath here = placeOnPiece(pose);
  const size_t next = here.next == 0 ? 0 : here.next - 1;
  const navigation::Path ahead(
      path_.begin() + static_cast<std::ptrdiff_t>(first_ + next), path_.end());
  const auto limits = navigation::speedProfile(
      ahead, costmap, params_.drivetrain, std::abs(motion.speed_mps), params_.speed);
  // the first point's is what it has or must brake to, the second's what it may come to
  const bool may_grow = limits.size() > 1 && limits[1].speed_mps > limits[0].speed_mps;
  return limits[may_grow ? 1 : 0];
}

void WayFollower::goOn(const geometry::Pose2& pose)
{
  const bool has_next = last_ + 1 < path_.size();
  if (has_next && path_[last_].along_m - placeOnPiece(pose).along_m < kOver_m)
  {
    beginPiece(last_, pose);
  }
}

std::optional<geometry::Twist2> WayFollower::alongWay(
    const reactive::Senses& senses, const navigation::MotionGuard& guard)
{
  const bool is_car = params_.drivetrain.steering == geometry::Steering::ackermann;
  if (!is_car || path_.size() < 2 || senses.now < around_until_)
  {
    return std::nullopt;
  }
  const auto along =
      navigation::trackPath(piece(), senses.pose, senses.speed_limit_mps, params_.drivetrain);
  if (along)
  {
    const geometry::Twist2 passed = guard.guarded(*along, senses.motion, senses.obstacles);
    if (std::abs(passed.speed_mps) >= std::min(kBlocked_mps, senses.speed_limit_mps))
    {
      return along;
    }
  }
  around_until_ = poses::later(senses.now, kAround_s);
  return std::nullopt;
}

reactive::Command WayFollower::step(
    const reactive::Senses& senses, const navigation::MotionGuard& guard)
{
  if (path_.size() > 1)
  {
    goOn(senses.pose);
  }
  if (const auto along = alongWay(senses, guard))
  {
    return {*along, reactive::Outcome::driving, ""};
  }
  const reactive::Command command = driver().step(senses);
  const bool is_piece_over = command.outcome == reactive::Outcome::arrived;
  if (is_piece_over && last_ + 1 < path_.size())
  {
    beginPiece(last_, senses.pose);
    return driver().step(senses);
  }
  return command;
}
}  // namespace traverse::app
