// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "recorded_goals.h"
#include "referee.h"

#include <traverse/common_app/input_file.h>
#include <traverse/formats/trajectory.h>
#include <traverse/geometry/convex_distance.h>
#include <traverse/geometry/exact_trig.h>
#include <traverse/logs/log_poses.h>
#include <traverse/logs/log_reader.h>
#include <traverse/nav_app/replay.h>
#include <traverse/navigation/obstacle_points.h>
#include <traverse/poses/level_pose.h>

#include <algorithm>
#include <cmath>

namespace traverse::app
{
namespace
{
using poses::secondsBetween;

constexpr double kMotionOver_s = 0.1;
constexpr double kFarClearance_m = 5;

/** A longer time without a scan is passed over. */
constexpr double kLongestGap_s = 10;

poses::PoseTrack trackOf(
    const NavSettings& settings,
    const std::filesystem::path& log,
    const DriveOptions& options,
    ReplayResult& result)
{
  const poses::PoseParams& params = settings.poses;
  if (params.source == poses::PoseSource::identity)
  {
    throw config::ConfigError("[Poses] source = identity: a replay needs the way that was driven");
  }
  if (params.source == poses::PoseSource::file)
  {
    return poses::PoseTrack(
        asInput([&] { return formats::readTrajectory(params.file, params.times_file); }),
        params.limits());
  }
  logs::PoseReading reading =
      logs::readLogPoses(log, params, settings.log, settings.sensors, {options.stop, false, {}});
  if (!reading.report.complete())
  {
    result.problem = reading.report.damage;
  }
  return poses::PoseTrack(std::move(reading.poses), params.limits());
}

/** When the last of its points was seen; its stamp where its times are none. */
poses::TimeNs arrivalOf(const points::ScanBuffer& scan)
{
  constexpr float kLongest_s = 10;
  float latest_s = 0;
  for (const float time_s : scan.time_s)
  {
    latest_s = time_s > latest_s && time_s < kLongest_s ? time_s : latest_s;
  }
  return poses::later(scan.stamp, static_cast<double>(latest_s));
}

class Replay
{
 public:
  Replay(
      const NavSettings& settings,
      poses::PoseTrack track,
      Pilot& pilot,
      const DriveOptions& options,
      ReplayResult& result) :
      settings_(settings),
      track_(std::move(track)),
      goals_(track_, settings.run),
      outline_(geometry::convexHull(geometry::footprintOf(settings.robot.vehicle))),
      pilot_(pilot),
      options_(options),
      result_(result),
      referee_(result)
  {
  }

  void take(points::Decoded& decoded)
  {
    steerUntil(arrivalOf(decoded.scan));
    ++(pilot_.take(decoded, track_) ? result_.scans : result_.scans_without_pose);
  }

  bool isOver() const { return result_.time_s >= settings_.run.max_time_s; }

 private:
  /** Control steps up to a time. */
  void steerUntil(poses::TimeNs time)
  {
    const double period_s = 1 / settings_.run.control_hz;
    if (now_ == 0)
    {
      now_ = time;
      result_.start = time;
    }
    if (secondsBetween(now_, time) > kLongestGap_s)
    {
      now_ = time;
    }
    for (; now_ < time && !isOver(); now_ = poses::later(now_, period_s))
    {
      step();
      result_.time_s = secondsBetween(result_.start, now_);
    }
  }

  void step()
  {
    if (const auto here = track_.at(now_))
    {
      pose_ = poses::seenFromAbove(here->T_map_base);
      measured_ = now_;
    }
    else
    {
      result_.off_track_s += 1 / settings_.run.control_hz;
    }
    if (measured_ == 0)
    {
      return;  // it is not yet anywhere
    }
    if (const auto goal = goals_.next(now_))
    {
      pilot_.startOver(*goal);
    }
    DriveRecord record;
    record.t_s = secondsBetween(result_.start, now_);
    record.vehicle.pose = pose_;
    record.vehicle.twist = motionNow();
    record.vehicle.wheels = record.vehicle.twist;
    record.believed = pose_;
    record.pilot = pilot_.step(now_, measured_, pose_, record.vehicle.twist);
    record.clearance_m = clearance_m();
    referee_.judge(record);
    result_.records.push_back(record);
    if (options_.watch)
    {
      options_.watch(pilot_, result_);
    }
  }

  /** As it drove over the last kMotionOver_s. */
  geometry::Twist2 motionNow() const
  {
    const auto before = track_.at(poses::later(now_, -kMotionOver_s));
    const auto after = track_.at(now_);
    if (!before || !after || before->segment != after->segment)
    {
      return {};
    }
    const geometry::Pose2 from = poses::seenFromAbove(before->T_map_base);
    const geometry::Pose2 to = poses::seenFromAbove(after->T_map_base);
    const geometry::SinCos yaw = geometry::sinCosOfAny(to.yaw_rad);
    const double ahead_m = (to.x_m - from.x_m) * yaw.cos + (to.y_m - from.y_m) * yaw.sin;
    const double turn_rad = std::remainder(to.yaw_rad - from.yaw_rad, 2 * geometry::kPi);
    return {ahead_m / kMotionOver_s, turn_rad / kMotionOver_s};
  }

  /** To what the maps call an obstacle. */
  double clearance_m() const
  {
    double least_m = kFarClearance_m;
    if (pilot_.costmap().size() > 0)
    {
      for (const Eigen::Vector3f& p :
           navigation::obstaclePoints(pilot_.costmap(), pose_, kFarClearance_m))
      {
        least_m = std::min(least_m, geometry::apart(p.head<2>().cast<double>(), outline_));
      }
    }
    return least_m;
  }

  const NavSettings& settings_;
  poses::PoseTrack track_;
  RecordedGoals goals_;
  geometry::Outline outline_;
  Pilot& pilot_;
  const DriveOptions& options_;
  ReplayResult& result_;
  Referee referee_;
  poses::TimeNs now_ = 0;
  poses::TimeNs measured_ = 0;
  geometry::Pose2 pose_;
};
}  // namespace

ReplayResult replay(
    const NavSettings& settings,
    const std::filesystem::path& log,
    Pilot& pilot,
    const DriveOptions& options)
{
  ReplayResult result;
  poses::PoseTrack track = trackOf(settings, log, options, result);
  Replay run(settings, std::move(track), pilot, options, result);
  logs::LogReader reader(log, settings.log, settings.sensors, {options.stop, false, {}});
  while (!run.isOver())
  {
    std::optional<points::Decoded> decoded = reader.next();
    if (!decoded)
    {
      break;
    }
    run.take(*decoded);
  }
  const logs::LogReport& report = reader.report();
  result.interrupted = report.end == logs::LogEnd::stopped;
  result.end = result.interrupted ? "interrupted" : run.isOver() ? "max_time_s" : "the log's end";
  if (report.end == logs::LogEnd::damaged || report.end == logs::LogEnd::not_a_log)
  {
    result.problem = report.damage;
    result.end = "the log's damage";
  }
  return result;
}
}  // namespace traverse::app
