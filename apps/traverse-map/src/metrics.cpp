// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "metrics.h"

#include "metrics_json.h"

#include <algorithm>
#include <sys/resource.h>

namespace traverse::app
{
namespace
{

template <class Pairs>
Json object(const Pairs& pairs)
{
  Json all = Json::object();
  for (const auto& [key, value] : pairs)
  {
    all[key] = value;
  }
  return all;
}

Json rejectsOf(const points::RejectCounts& counts)
{
  Json all = Json::object();
  for (size_t i = 0; i < points::kRejectCount; ++i)
  {
    all[std::string(points::kRejectNames[i])] = counts.count[i];
  }
  return all;
}

Json mapsOf(const RunMetrics& metrics)
{
  Json maps = Json::array();
  for (const MapMetrics& map : metrics.maps)
  {
    maps.push_back(
        {{"name", map.name},
         {"scans", map.scans},
         {"scans_without_pose", map.scans_no_pose},
         {"points", map.points},
         {"points_outside", map.outside},
         {"points_bad", map.bad_points},
         {"points_over_budget", map.over_budget},
         {"cells_by_class", object(map.cells_by_class)}});
  }
  return maps;
}

Json snapshotsOf(const RunMetrics& metrics)
{
  Json snapshots = Json::array();
  for (const SnapshotMetrics& snapshot : metrics.snapshots)
  {
    snapshots.push_back(
        {{"map", snapshot.map}, {"file", snapshot.file}, {"time_s", snapshot.time_s}});
  }
  return snapshots;
}

Json pieceOf(const PieceMetrics& piece)
{
  return {
      {"number", piece.number},
      {"of", piece.of},
      {"whole", piece.whole},
      {"log_entries", piece.log_entries},
      {"log_bytes", piece.log_bytes},
      {"log_crc32", piece.log_crc32},
      {"poses_crc32", piece.poses_crc32},
      {"log_problems", piece.log_problems},
      {"log_warnings", piece.log_warnings}};
}
}  // namespace

void StageTimes::add(const std::string& stage, double seconds)
{
  const auto found = std::find_if(
      seconds_.begin(), seconds_.end(), [&](const auto& entry) { return entry.first == stage; });
  if (found == seconds_.end())
  {
    seconds_.emplace_back(stage, seconds);
  }
  else
  {
    found->second += seconds;
  }
}

double StageTimes::total_s() const
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

double peakMemory_mb()
{
  double kilobytes = 0;
  for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN})
  {
    rusage usage{};
    getrusage(who, &usage);
    kilobytes = std::max(kilobytes, static_cast<double>(usage.ru_maxrss));
  }
  return kilobytes / 1024.0;
}

std::string toJson(const RunMetrics& metrics)
{
  const double total_s = metrics.times.total_s();
  Json json = {
      {"traverse_version", TRAVERSE_VERSION},
      {"title", metrics.title},
      {"rawlog", metrics.rawlog},
      {"complete", metrics.complete},
      {"problems", metrics.problems},
      {"warnings", metrics.warnings},
      {"objects", metrics.objects},
      {"observations", object(metrics.observations)},
      {"observations_ignored", object(metrics.ignored)},
      {"observations_rejected", object(metrics.rejected)},
      {"rejects", rejectsOf(metrics.rejects)},
      {"stamps",
       {{"repeated", metrics.repeated_stamps},
        {"backward", metrics.backward_stamps},
        {"bad", metrics.bad_stamps}}},
      {"scans", metrics.scans},
      {"first_stamp_s", metrics.first_stamp_s},
      {"last_stamp_s", metrics.last_stamp_s},
      {"points", metrics.points},
      {"pose_source", metrics.pose_source},
      {"poses", object(metrics.poses)},
      {"pose_notes", object(metrics.pose_notes)},
      {"poses_rejected", object(metrics.poses_rejected)},
      {"pose_quality", object(metrics.pose_quality)},
      {"deskew", object(metrics.deskew)},
      {"maps", mapsOf(metrics)},
      {"files", metrics.files},
      {"seconds", object(metrics.times.seconds())},
      {"seconds_total", total_s},
      {"points_per_second", total_s > 0 ? static_cast<double>(metrics.points) / total_s : 0.0},
      {"peak_memory_mb", peakMemory_mb()}};
  if (!metrics.snapshots.empty())
  {
    json["snapshots"] = snapshotsOf(metrics);
  }
  if (metrics.piece)
  {
    json["piece"] = pieceOf(*metrics.piece);
    json["crc32"] = metricsChecksum(json);
  }
  if (metrics.merged_pieces > 0)
  {
    json["merged_pieces"] = metrics.merged_pieces;
  }
  return textOf(json) + "\n";
}
}  // namespace traverse::app
