// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mapping.h"

#include "piece.h"
#include "scan_feed.h"

#include <traverse/common_app/interrupt.h>
#include <traverse/common_app/progress.h>
#include <traverse/logs/log_reader.h>

#include <algorithm>
#include <fmt/format.h>
#include <future>

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

/** All maps; `threads` - 1 of them at a time, as one thread reads. */
void insertIntoAll(
    const points::Scan& scan,
    const poses::PoseTrack& track,
    int threads,
    std::vector<BuiltMap>& maps,
    std::vector<MapMetrics>& metrics)
{
  const auto every_nth = [&](size_t first, size_t n)
  {
    for (size_t i = first; i < maps.size(); i += n)
    {
      insert(scan, track, maps[i], metrics[i]);
    }
  };
  const size_t hands = std::clamp<size_t>(static_cast<size_t>(threads) - 1, 1, maps.size());
  std::vector<std::future<void>> others;
  for (size_t hand = 1; hand < hands; ++hand)
  {
    others.push_back(std::async(std::launch::async, every_nth, hand, hands));
  }
  every_nth(0, hands);
  for (std::future<void>& other : others)
  {
    other.get();
  }
}

/** The piece is whole where all its entries were met; what is damaged behind the last is nobody's.
 */
void noteWhole(const logs::LogReport& report, PieceMetrics& piece)
{
  const logs::EntryRange entries = entriesOf({piece.number, piece.of}, piece.log_entries);
  const uint64_t expected = std::min(entries.end, piece.log_entries) - entries.first;
  const bool ended = report.end == logs::LogEnd::complete || report.end == logs::LogEnd::damaged;
  piece.whole = ended && report.objects == expected;
  if (!report.damage.empty() && report.end == logs::LogEnd::damaged)
  {
    piece.log_problems.push_back(report.damage);
  }
}

/** Clouds whose rings and times are lost are mapped without them. */
void noteChannels(const logs::LogReport& report, RunMetrics& metrics)
{
  if (!report.channels_damage.empty())
  {
    metrics.complete = false;
    metrics.warnings.push_back("rings and times of points: " + report.channels_damage);
  }
  for (const auto& [what, clouds] : report.channels)
  {
    if (what.rfind("the side file's", 0) == 0)
    {
      metrics.warnings.push_back(
          fmt::format("{} clouds without ring and time of points: {}", clouds, what));
    }
  }
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
  metrics.sensors = report.sensors;
  noteChannels(report, metrics);
  if (metrics.piece)
  {
    noteWhole(report, *metrics.piece);
  }
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
    const PreparedScan& prepared,
    const Context& context,
    std::vector<BuiltMap>& maps,
    RunMetrics& metrics)
{
  const points::Decoded& decoded = prepared.decoded;
  metrics.last_stamp_s = static_cast<double>(decoded.scan.stamp) * poses::kSecondsPerNs;
  metrics.first_stamp_s = metrics.scans == 0 ? metrics.last_stamp_s : metrics.first_stamp_s;
  ++metrics.scans;
  metrics.points += decoded.scan.size();
  metrics.rejects += decoded.rejects;
  metrics.times.add("read and decode", prepared.read_s);
  if (prepared.deskew)
  {
    ++metrics.deskew[nameOf(*prepared.deskew)];
    metrics.times.add("deskew", prepared.deskew_s);
  }
  const auto pose = context.track.at(decoded.scan.stamp);
  ++metrics.pose_quality[pose ? nameOf(pose->quality) : "none"];
  metrics.times.during(
      "insert",
      [&]
      {
        insertIntoAll(
            decoded.view(), context.track, context.settings.run.threads, maps, metrics.maps);
      });
}
}  // namespace

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

void listMaps(const std::vector<BuiltMap>& maps, RunMetrics& metrics)
{
  for (const BuiltMap& map : maps)
  {
    metrics.maps.emplace_back().name = map.title();
  }
}

void mapLog(
    const Settings& settings,
    const poses::PoseTrack& track,
    std::vector<BuiltMap>& maps,
    RunMetrics& metrics,
    const AfterScan& after_scan)
{
  listMaps(maps, metrics);
  const bool any_time_will_do = settings.poses.source == poses::PoseSource::identity;
  const logs::EntryRange entries =
      settings.piece ? entriesOf(*settings.piece, metrics.piece->log_entries) : logs::EntryRange();
  // Made here, as its child process dies with the thread that made it.
  logs::LogReader reader(
      settings.rawlog, settings.log, settings.sensors,
      {&Interrupt::flag(), any_time_will_do, entries});
  Progress progress("mapping", "scans", settings.quiet);
  {
    ScanFeed feed(reader, settings, track);
    while (const std::optional<PreparedScan> scan = feed.next())
    {
      mapScan(*scan, {settings, track}, maps, metrics);
      after_scan(scan->decoded);
      progress.show(scan->fraction_read, metrics.scans);
    }
  }
  progress.finish(metrics.scans);
  takeReport(reader.report(), metrics);
}
}  // namespace traverse::app
