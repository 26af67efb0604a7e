// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verdict.h"

#include <traverse/common_app/interrupt.h>

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <set>
#include <sstream>

namespace traverse::app
{
namespace
{
/** What a user must know of a map that did not take everything. */
void noteAbout(const MapMetrics& map, RunMetrics& metrics)
{
  constexpr uint64_t kTenth = 10;  // a log's first and last scans often have no pose
  if (map.scans == 0 && map.outside > 0)
  {
    metrics.problems.push_back(
        fmt::format("{}: all {} points lie outside its extent", map.name, map.outside));
    metrics.complete = false;
  }
  else if (map.scans == 0)
  {
    metrics.problems.push_back(fmt::format(
        "{}: no scan was inserted ({} of {} had no valid pose; [Poses] source = {})", map.name,
        map.scans_no_pose, metrics.scans, metrics.pose_source));
    if (metrics.poses["kept"] == 0)
    {
      metrics.problems.push_back(fmt::format(
          "the log has no poses of source '{}'{}: try [Poses] source = icp_3d or icp_2d, or "
          "identity "
          "for a robot that stands still",
          metrics.pose_source,
          metrics.pose_source == "ins" ? " (CObservationGPS with good fixes, and a heading)" : ""));
    }
    metrics.complete = false;
  }
  else if (map.scans_no_pose > 0)
  {
    metrics.warnings.push_back(fmt::format(
        "{}: {} of {} scans had no valid pose", map.name, map.scans_no_pose, metrics.scans));
  }
  if (map.scans_no_pose * kTenth > metrics.scans)
  {
    metrics.complete = false;
  }
  if (map.over_budget > 0)
  {
    metrics.complete = false;
    metrics.warnings.push_back(
        fmt::format("{}: {} points found no room; raise max_memory_mb", map.name, map.over_budget));
  }
}
}  // namespace

void noteWhatIsMissing(RunMetrics& metrics)
{
  if (Interrupt::exitCode())
  {
    metrics.complete = false;
    metrics.problems.emplace_back(
        metrics.scans == 0 ? "interrupted before anything was mapped"
                           : "interrupted: what was finished is saved");
  }
  if (metrics.scans == 0 && metrics.problems.empty() && !hasResults(metrics))
  {
    metrics.problems.push_back(fmt::format("{}: nothing in it became points", metrics.rawlog));
  }
  if (metrics.scans == 0)
  {
    return;
  }
  if (const uint64_t skewed = metrics.deskew["no_poses"]; skewed > 0)
  {
    metrics.warnings.push_back(fmt::format(
        "{} of {} scans are not corrected for motion: no poses at the times of their points",
        skewed, metrics.scans));
  }
  const bool has_poses = std::any_of(
      metrics.sensors.begin(), metrics.sensors.end(),
      [](const logs::SensorTimes& sensor)
      {
        return sensor.count > 1 &&
               (sensor.type == "CObservationRobotPose" || sensor.type == "CObservationOdometry" ||
                sensor.type == "CActionRobotMovement2D");
      });
  if (metrics.pose_source == "identity" && metrics.scans > 1 && has_poses)
  {
    metrics.warnings.emplace_back(
        "the log has poses, but [Poses] source = identity takes the robot for standing still");
  }
  for (const MapMetrics& map : metrics.maps)
  {
    noteAbout(map, metrics);
  }
}

void noteAbsentLabels(const observations::ObservationParams& sensors, RunMetrics& metrics)
{
  std::set<std::string> labels;
  for (const logs::SensorTimes& sensor : metrics.sensors)
  {
    labels.insert(sensor.label);
  }
  std::istringstream wanted(sensors.sensor_labels);
  for (std::string label; !labels.empty() && wanted >> label;)
  {
    if (labels.count(label) == 0)
    {
      constexpr std::ptrdiff_t kMostNamed = 20;
      const auto end =
          labels.size() > kMostNamed ? std::next(labels.begin(), kMostNamed) : labels.end();
      metrics.warnings.push_back(fmt::format(
          "[Sensors] sensor_labels names '{}', which nothing in the log has; it has '{}'{}", label,
          fmt::join(labels.begin(), end, "', '"), end == labels.end() ? "" : " and more"));
    }
  }
}

bool hasResults(const RunMetrics& metrics)
{
  return metrics.scans > 0 || (metrics.piece && metrics.piece->whole);
}

ExitCode verdict(const RunMetrics& metrics)
{
  if (const auto interrupted = Interrupt::exitCode())
  {
    return *interrupted;
  }
  if (!hasResults(metrics))
  {
    return ExitCode::unreadable;
  }
  return metrics.complete ? ExitCode::done : ExitCode::partial;
}
}  // namespace traverse::app
