// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/navigation/planner.h>
#include <traverse/options/option.h>
#include <traverse/poses/pose_track.h>

#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace traverse::navigation
{
/** Section [Watchdogs]. */
struct WatchdogParams
{
  double max_map_age_s = 0.5;
  double max_pose_age_s = 0.3;
  double max_pose_jump_m = 1.0;
  double no_way_s = 2.0;
  double stuck_s = 4.0;
  double stuck_m = 0.1;
  int most_recoveries = 5;

  friend bool operator==(const WatchdogParams&, const WatchdogParams&) = default;
};

template <class P, class F>
requires std::same_as<std::remove_const_t<P>, WatchdogParams>

void visit(P& p, F&& f)
{
  using options::Option;
  f(Option{"max_map_age_s", "with no newer scan in its maps the vehicle stops, s", {0.05, 60}},
    p.max_map_age_s);
  f(Option{"max_pose_age_s", "with no newer pose the vehicle stops, s", {0.02, 60}},
    p.max_pose_age_s);
  f(
      Option{
          "max_pose_jump_m",
          "a pose that jumps so much further than at its speed says that the place is lost, m",
          {0.01, 100}},
      p.max_pose_jump_m);
  f(Option{"no_way_s", "so long without a way it stands for good, s", {0.1, 3600}}, p.no_way_s);
  f(
      Option{
          "stuck_s",
          "it drives for so long, and comes no further than stuck_m: recovery, s",
          {0.5, 3600}},
      p.stuck_s);
  f(Option{"stuck_m", "likewise, m", {0.01, 10}}, p.stuck_m);
  f(Option{"most_recoveries", "then it stands for good", {0, 1000}}, p.most_recoveries);
}

/** What the vehicle is to do. */
enum class Conduct : uint8_t
{
  drive,    //!< as the reactive layer says
  stop,     //!< stand, and wait for what is missing
  recover,  //!< back off the way it came, then plan anew
  give_up,  //!< stand for good: the mission has failed
  arrived,  //!< stand: the last goal is reached
};

/** Why. */
enum class Cause : uint8_t
{
  none,
  stale_map,
  stale_pose,
  lost_pose,
  no_way,
  blocked,  //!< a way is planned, and the reactive layer finds no motion
  stuck,
  goal_in_obstacle,
  arrived,
};

/** For people and reports: "stale_map" ... */
std::string_view nameOf(Conduct conduct);
std::string_view nameOf(Cause cause);

/** What a watchdog sees of one control step. */
struct Situation
{
  poses::TimeNs now = 0;
  poses::TimeNs last_scan = 0;  //!< that the maps took
  poses::TimeNs last_pose = 0;
  geometry::Pose2 pose;
  bool has_way = false;          //!< there is a plan
  bool has_motion = false;       //!< the reactive layer found a command
  bool wants_motion = false;     //!< the command is not to stand
  bool is_goal_blocked = false;  //!< the goal lies in an obstacle or hard buffer
  double to_goal_m = 0;
};

/** One decision that differs from the one before. */
struct Decision
{
  poses::TimeNs time = 0;
  Conduct conduct = Conduct::stop;
  Cause cause = Cause::none;
  std::string text;  //!< with the numbers that decided
};

/** Holds what happens against its limits, step by step; the first that applies decides:
 *
 *   no newer pose, no newer scan       stops, drives on once there is one
 *   a pose jumps                       stops until poses have been steady for kSettle_s
 *   the goal is near                   arrived, until nextGoal()
 *   no way                             stops, gives up after no_way_s (cause: no_way, or
 *                                      goal_in_obstacle)
 *   a way and no motion                stops; after half of no_way_s backs off for kBackOff_s, and
 *                                      gives up when that was done most_recoveries times; does not
 *                                      back off from a goal in an obstacle
 *   it drives, and gets nowhere        backs off; likewise
 *
 * Turning by kTurned_rad is getting somewhere. Giving up is final, until startOver(). */
class Supervisor
{
 public:
  static constexpr double kSettle_s = 1.0;
  static constexpr double kBackOff_s = 1.5;
  static constexpr double kTurned_rad = 1.0;

  /** Throws options::OptionError. */
  Supervisor(const WatchdogParams& params, double goal_tolerance_m);

  /** Times must not go back. */
  Conduct step(const Situation& situation);

  /** The mission's next goal: what was waited for is forgotten, recoveries are not. */
  void nextGoal();

  /** Another mission: all but the log and the last pose is forgotten. */
  void startOver();

  int recoveries() const { return recoveries_; }

  /** All changes of conduct or cause so far. */
  const std::vector<Decision>& log() const { return log_; }

 private:
  using Verdict = std::optional<Decision>;

  Decision judge(const Situation& now);
  Verdict senses(const Situation& now) const;
  Verdict jump(const Situation& now);
  Decision withoutWay(const Situation& now);
  Decision withoutMotion(const Situation& now);
  Verdict stuck(const Situation& now);
  Decision recover(const Situation& now, Cause cause, const std::string& why);
  void forgetWaiting();
  double hinderedFor_s(const Situation& now);

  WatchdogParams params_;
  double goal_tolerance_m_;
  std::vector<Decision> log_;
  Verdict final_;                                //!< arrived or given up
  std::optional<poses::TimeNs> hindered_since_;  //!< no way, or no motion
  std::optional<Situation> before_;              //!< the step with the latest pose
  double last_speed_mps_ = 0;                    //!< as poses say
  std::optional<poses::TimeNs> jumped_;
  double jumped_by_m_ = 0;
  std::optional<geometry::Pose2> stuck_from_;
  poses::TimeNs stuck_since_ = 0;
  std::optional<poses::TimeNs> recover_until_;
  Cause recover_cause_ = Cause::none;
  int recoveries_ = 0;
};
}  // namespace traverse::navigation
