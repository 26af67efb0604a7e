// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/common_app/map_set.h>
#include <traverse/nav_app/latency.h>
#include <traverse/nav_app/settings.h>
#include <traverse/nav_app/way_follower.h>
#include <traverse/navigation/costmap.h>
#include <traverse/navigation/planner.h>
#include <traverse/points/decoded.h>
#include <traverse/poses/pose_track.h>

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

namespace traverse::app
{
/** What the pilot decided in a control step. */
struct PilotStep
{
  geometry::Twist2 command;
  navigation::Conduct conduct = navigation::Conduct::stop;
  navigation::Cause cause = navigation::Cause::none;
  double speed_limit_mps = 0;
  navigation::SpeedReason limited_by = navigation::SpeedReason::vehicle;
};

/** From scans to commands: maps -> costmap -> way -> speed -> reactive layer -> watchdogs. Knows
 * nothing of where scans and poses come from. */
class Pilot
{
 public:
  /** Needs plugin::registerAllMaps(). Throws config::ConfigError for maps that cannot be made,
   * std::runtime_error where MRPT's navigator refuses. */
  Pilot(
      const NavSettings& settings,
      const std::filesystem::path& cache,
      const std::filesystem::path& log_folder = {});

  /** The mission's next goal. */
  void goTo(const navigation::Goal& goal);

  /** A goal of another mission, also where the last one was given up. */
  void startOver(const navigation::Goal& goal);

  /** Deskews a scan and takes it into all maps; false where the track has no pose for it. */
  bool take(points::Decoded& decoded, const poses::PoseTrack& track);

  /** A control step at a pose that was last measured (not only reckoned) at a time. Times must
   * grow. */
  PilotStep step(
      poses::TimeNs now,
      poses::TimeNs measured,
      const geometry::Pose2& pose,
      const geometry::Twist2& motion);

  /** What the costs at a place consist of, by the maps as they are; key and value. */
  std::vector<layers::Fact> explain(double x_m, double y_m) const;

  const std::vector<BuiltMap>& maps() const { return maps_; }

  const navigation::Costmap& costmap() const { return costmap_; }

  const navigation::Plan& plan() const { return plan_; }

  const std::vector<navigation::Decision>& decisions() const { return supervisor_.log(); }

  /** How often a new way was planned, by reason (navigation::Replan). */
  const std::array<uint64_t, 5>& plans() const { return plans_; }

  const Latencies& latencies() const { return latencies_; }

 private:
  std::vector<layers::LayerSet> layerSets(
      const geometry::CellRect& extent, const geometry::Lattice& lattice) const;
  std::vector<navigation::MapLayers> named(const std::vector<layers::LayerSet>& sets) const;
  void lookAtMaps(poses::TimeNs now, const geometry::Pose2& pose);
  void keepWay(poses::TimeNs now, const geometry::Pose2& pose, const geometry::Twist2& motion);

  /** Told to drive, and held by the guard for a second, a car needs a way from where it stands. */
  void heedStanding(const reactive::Senses& senses, const geometry::Twist2& command);
  geometry::Twist2 backOff(
      const geometry::Twist2& motion, std::span<const Eigen::Vector3f> obstacles) const;
  navigation::Plan planOnwards(const geometry::Pose2& pose, const geometry::Twist2& motion);
  navigation::Plan planToGoal(const geometry::Pose2& pose);
  bool isGoalBlocked() const;
  PilotStep decide(
      poses::TimeNs now,
      poses::TimeNs measured,
      const geometry::Pose2& pose,
      const geometry::Twist2& motion);

  const NavSettings& settings_;
  std::vector<BuiltMap> maps_;
  navigation::Planner planner_;
  WayFollower follower_;
  navigation::MotionGuard guard_;
  navigation::Supervisor supervisor_;
  navigation::Costmap costmap_;
  navigation::Plan plan_;
  std::optional<navigation::Goal> goal_;
  std::array<uint64_t, 5> plans_{};
  Latencies latencies_;
  poses::TimeNs last_scan_ = 0;
  poses::TimeNs last_look_ = 0;
  poses::TimeNs last_plan_ = 0;
  std::optional<poses::TimeNs> standing_since_;
  bool has_news_ = false;
};
}  // namespace traverse::app
