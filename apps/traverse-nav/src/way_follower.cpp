// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/nav_app/way_follower.h>

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

double squared(const geometry::Pose2& a, const geometry::Pose2& b)
{
  const double dx = a.x_m - b.x_m;
  const double dy = a.y_m - b.y_m;
  return dx * dx + dy * dy;
}
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

size_t WayFollower::nearest(const geometry::Pose2& pose) const
{
  size_t found = first_;
  for (size_t i = first_; i <= last_; ++i)
  {
    found = squared(path_[i].pose, pose) < squared(path_[found].pose, pose) ? i : found;
  }
  return found;
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
  const double from_m = path_[nearest(pose)].along_m;
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
  const navigation::Path ahead(
      path_.begin() + static_cast<std::ptrdiff_t>(nearest(pose)), path_.end());
  const auto limits = navigation::speedProfile(
      ahead, costmap, params_.drivetrain, std::abs(motion.speed_mps), params_.speed);
  // the first point's is what it has or must brake to, the second's what it may come to
  const bool may_grow = limits.size() > 1 && limits[1].speed_mps > limits[0].speed_mps;
  return limits[may_grow ? 1 : 0];
}

reactive::Command WayFollower::step(const reactive::Senses& senses)
{
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
