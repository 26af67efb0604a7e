// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "track.h"

#include <traverse/common_app/input_file.h>
#include <traverse/formats/trajectory.h>
#include <traverse/logs/log_poses.h>

#include <cmath>
#include <cstdlib>
#include <fmt/format.h>

namespace traverse::app
{
namespace
{
/** An inertial unit whose yaw counts from elsewhere turns the map, and smears it. */
void warnOfHeading(const poses::PoseParams& params, RunMetrics& metrics)
{
  constexpr double kSuspicious_deg = 15;
  const auto off = metrics.pose_notes.find("heading_off_course_deg");
  if (params.ins_heading == poses::InsHeading::imu && off != metrics.pose_notes.end() &&
      std::abs(std::strtod(off->second.c_str(), nullptr)) > kSuspicious_deg)
  {
    metrics.warnings.push_back(fmt::format(
        "poses: the way driven is {} deg off the IMU's heading: see [Poses] ins_heading",
        off->second));
  }
}

std::vector<poses::StampedPose> posesOf(
    const Settings& settings, RunMetrics& metrics, const std::atomic<bool>& stop)
{
  if (settings.poses.source == poses::PoseSource::file)
  {
    return asInput(
        [&] { return formats::readTrajectory(settings.poses.file, settings.poses.times_file); });
  }
  logs::PoseReading reading = logs::readLogPoses(
      settings.rawlog, settings.poses, settings.log, settings.sensors, {&stop, false, {}});
  if (reading.report.complete())
  {
    metrics.log_entries = reading.report.objects;
  }
  if (!reading.report.complete() && reading.report.end != logs::LogEnd::stopped)
  {
    metrics.problems.push_back("poses: " + reading.report.damage);
    metrics.complete = false;
  }
  metrics.pose_notes = reading.report.notes;
  metrics.poses_rejected = reading.report.rejected;
  for (const auto& [what, n] : reading.report.rejected)
  {
    metrics.warnings.push_back(fmt::format("poses: {} without one: {}", n, what));
  }
  warnOfHeading(settings.poses, metrics);
  return std::move(reading.poses);
}

void tell(const poses::PoseTrack& track, RunMetrics& metrics)
{
  const poses::TrackReport& r = track.report();
  metrics.poses = {{"kept", r.poses},        {"nonfinite", r.nonfinite}, {"repeated", r.repeated},
                   {"backward", r.backward}, {"gaps", r.gaps},           {"segments", r.segments}};
  if (r.segments > 1)
  {
    metrics.warnings.push_back(fmt::format(
        "poses: {} jumps that the vehicle cannot drive; each starts a new segment",
        r.segments - 1));
  }
  if (r.gaps > 0)
  {
    metrics.warnings.push_back(fmt::format("poses: {} gaps longer than max_pose_age_s", r.gaps));
  }
}
}  // namespace

poses::PoseTrack makeTrack(
    const Settings& settings, RunMetrics& metrics, const std::atomic<bool>& stop)
{
  metrics.pose_source = options::format(settings.poses.source);
  if (settings.poses.source == poses::PoseSource::identity)
  {
    poses::PoseTrack still = poses::PoseTrack::constant(Eigen::Isometry3d::Identity());
    tell(still, metrics);
    return still;
  }
  poses::PoseTrack track(posesOf(settings, metrics, stop), settings.poses.limits());
  tell(track, metrics);
  return track;
}
}  // namespace traverse::app
