// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/drivetrain.h>
#include <traverse/navigation/motion_guard.h>
#include <traverse/navigation/on_path.h>
#include <traverse/navigation/path.h>
#include <traverse/navigation/speed_profile.h>
#include <traverse/reactive/reactive_driver.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <span>

namespace traverse::app
{
/** What a WayFollower is made of. */
struct FollowerParams
{
  geometry::Vehicle vehicle;
  geometry::Drivetrain drivetrain;
  reactive::ReactiveParams reactive;
  navigation::SpeedParams speed;
};

/** Follows a path piece by piece, from one change between forward and backward to the next, with
 * MRPT's reactive navigator. Forward pieces are driven by trajectories that lead forward only:
 * with others at hand it would drive backward for minutes, blind, where that is a little shorter.
 * A car-like vehicle has a second navigator for backward pieces; and as long as nothing stands on
 * the arcs of its path it drives these (trackPath()), for a reactive navigator cuts the corners
 * that were planned for a vehicle that cannot turn on the spot. */
class WayFollower
{
 public:
  /** Throws as ReactiveDriver does. */
  WayFollower(
      const FollowerParams& params,
      const std::filesystem::path& cache,
      const std::filesystem::path& log_folder);

  /** Empty: nothing, the vehicle stands. */
  void follow(const navigation::Path& path, const geometry::Pose2& pose);

  /** Highest speed at the pose by the path ahead; 0 where there is none. */
  navigation::SpeedLimit limitAt(
      const geometry::Pose2& pose,
      const geometry::Twist2& motion,
      const navigation::Costmap& costmap) const;

  reactive::Command step(const reactive::Senses& senses, const navigation::MotionGuard& guard);

 private:
  reactive::ReactiveDriver& driver();
  std::span<const navigation::PathPoint> piece() const;
  navigation::OnPath placeOnPiece(const geometry::Pose2& pose) const;
  void goOn(const geometry::Pose2& pose);
  std::optional<geometry::Twist2> alongWay(
      const reactive::Senses& senses, const navigation::MotionGuard& guard);
  void beginPiece(size_t first, const geometry::Pose2& pose);

  FollowerParams params_;
  reactive::ReactiveDriver forward_;
  std::unique_ptr<reactive::ReactiveDriver> backward_;
  navigation::Path path_;
  size_t first_ = 0;  // of the piece
  size_t last_ = 0;   // where it ends, and the next one begins
  poses::TimeNs around_until_ = 0;
};
}  // namespace traverse::app
