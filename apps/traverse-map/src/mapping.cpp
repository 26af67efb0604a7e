// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mapping.h"

#include <traverse/common_app/interrupt.h>
#include <traverse/common_app/progress.h>
#include <traverse/logs/log_reader.h>
#include <traverse/points/deskew.h>

#include <fmt/format.h>

namespace traverse::app
{
namespace
{
const char* nameOf(points::Deskew deskew)
{
  switch (deskew)
  {
    case points::Deskew::corrected:
      return "corrected";
    case points::Deskew::not_needed:
      return "not_needed";
    case points::Deskew::no_poses:
      return "no_poses";
  }
  return "?";
}

const char* nameOf(poses::PoseQuality quality)
{
  switch (quality)
  {
    case poses::PoseQuality::interpolated:
      return "interpolated";
    case poses::PoseQuality::extrapolated:
      return "extrapolated";
    case poses::PoseQuality::held:
      return "held";
  }
  return "?";
}

void insert(
    const points::Scan& scan, const poses::PoseTrack& track, BuiltMap& map, MapMetrics& metrics)
{
  const layers::UpdateStats stats = map.consumer->insertScan(scan, track);
  metrics.scans += static_cast<uint64_t>(stats.inserted);
  metrics.scans_no_pose += static_cast<uint64_t>(stats.no_pose);
  metrics.points += stats.points;
  metrics.outside += stats.outside;
  metrics.bad_points += stats.bad_points;
  metrics.over_budget += stats.over_budget;
}

double fractionRead(const logs::LogReport& report)
{
  return report.file_size == 0
             ? 0.0
             : static_cast<double>(report.bytes_read) / static_cast<double>(report.file_size);
}

void takeReport(const logs::LogReport& report, RunMetrics& metrics)
{
  metrics.objects = report.objects;
  metrics.observations = report.observations;
  metrics.ignored = report.ignored;
  metrics.rejected = report.rejected;
  metrics.repeated_stamps = report.repeated_stamps;
  metrics.backward_stamps = report.backward_stamps;
  metrics.bad_stamps = report.bad_stamps;
  if (!report.complete() && report.end != logs::LogEnd::reading &&
      report.end != logs::LogEnd::stopped)
  {
    metrics.complete = false;
    metrics.problems.push_back(report.damage);
  }
}

/** What a scan is mapped with. */
struct Context
{
  const Settings& settings;
  const poses::PoseTrack& track;
};

void mapScan(
    points::Decoded& decoded,
    const Context& context,
    std::vector<BuiltMap>& maps,
    RunMetrics& metrics)
{
  metrics.last_stamp_s = static_cast<double>(decoded.scan.stamp) * poses::kSecondsPerNs;
  metrics.first_stamp_s = metrics.scans == 0 ? metrics.last_stamp_s : metrics.first_stamp_s;
  ++metrics.scans;
  metrics.points += decoded.scan.size();
  metrics.rejects += decoded.rejects;
  if (context.settings.run.deskew)
  {
    ++metrics.deskew[nameOf(metrics.times.during(
        "deskew", [&] { return points::deskew(decoded.scan, context.track); }))];
  }
  const auto pose = context.track.at(decoded.scan.stamp);
  ++metrics.pose_quality[pose ? nameOf(pose->quality) : "none"];
  for (size_t i = 0; i < maps.size(); ++i)
  {
    metrics.times.during(
        "insert", [&] { insert(decoded.scan.view(), context.track, maps[i], metrics.maps[i]); });
  }
}
}  // namespace

void mapLog(
    const Settings& settings,
    const poses::PoseTrack& track,
    std::vector<BuiltMap>& maps,
    RunMetrics& metrics,
    const AfterScan& after_scan)
{
  for (const BuiltMap& map : maps)
  {
    metrics.maps.emplace_back().name = map.name + map.file_suffix;
  }
  const bool any_time_will_do = settings.poses.source == poses::PoseSource::identity;
  logs::LogReader reader(
      settings.rawlog, settings.log, settings.sensors, {&Interrupt::flag(), any_time_will_do});
  Progress progress("mapping", "scans", settings.quiet);
  const auto limit = static_cast<uint64_t>(settings.run.max_scans);
  while (limit == 0 || metrics.scans < limit)
  {
    std::optional<points::Decoded> decoded =
        metrics.times.during("read and decode", [&] { return reader.next(); });
    if (!decoded)
    {
      break;
    }
    mapScan(*decoded, {settings, track}, maps, metrics);
    after_scan(decoded->scan.stamp);
    progress.show(fractionRead(reader.report()), metrics.scans);
  }
  progress.finish(metrics.scans);
  takeReport(reader.report(), metrics);
}
}  // namespace traverse::app
