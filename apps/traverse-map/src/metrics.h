// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/logs/sensor_times.h>
#include <traverse/points/scan.h>

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace traverse::app
{
/** Seconds per stage of a run, in the order in which stages first ran. */
class StageTimes
{
 public:
  /** Runs `work` and adds its time to `stage`. */
  template <class Work>
  auto during(const std::string& stage, Work&& work)
  {
    const Stop stop{*this, stage};
    return work();
  }

  /** For work that was timed elsewhere. */
  void add(const std::string& stage, double seconds);

  const std::vector<std::pair<std::string, double>>& seconds() const { return seconds_; }

  /** Since this was made, by the clock on the wall: stages that ran side by side count once. */
  double total_s() const;

 private:
  struct Stop
  {
    StageTimes& times;
    const std::string& stage;
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();

    ~Stop()
    {
      times.add(
          stage, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
  };

  std::vector<std::pair<std::string, double>> seconds_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/** What one map took in and is. */
struct MapMetrics
{
  std::string name;
  uint64_t scans = 0;          //!< inserted
  uint64_t scans_no_pose = 0;  //!< skipped
  uint64_t points = 0;         //!< inserted
  uint64_t outside = 0;        //!< points beyond the map's extent
  uint64_t bad_points = 0;     //!< NaN or absurd
  uint64_t over_budget = 0;    //!< points that the memory budget had no cells for
  std::vector<std::pair<std::string, uint64_t>> cells_by_class;
};

/** Which part of a log a run mapped, and what tells that parts are of one log and one track. */
struct PieceMetrics
{
  uint64_t number = 1;  //!< from 1
  uint64_t of = 1;
  bool whole = false;                     //!< read to its end, or to the log's damage
  uint64_t log_entries = 0;               //!< of all pieces
  uint64_t log_bytes = 0;                 //!< size of the file
  uint32_t log_crc32 = 0;                 //!< of the file
  uint32_t poses_crc32 = 0;               //!< of the track
  std::vector<std::string> log_problems;  //!< of the log and its poses, as all pieces meet them
  std::vector<std::string> log_warnings;
};

/** The classes of a map as they were once. */
struct SnapshotMetrics
{
  std::string map;    //!< the file of its archive
  std::string file;   //!< of its class layer
  double time_s = 0;  //!< since 1970
};

/** What a run met and did: metrics.json. */
struct RunMetrics
{
  std::string title;
  std::string rawlog;
  std::optional<PieceMetrics> piece;    //!< of a run with --piece
  uint64_t merged_pieces = 0;           //!< of a run with --merge
  std::optional<uint64_t> log_entries;  //!< where a pass over the whole log has counted them
  bool complete = true;                 //!< the whole log was read, and nobody interrupted
  std::vector<std::string> problems;
  std::vector<std::string> warnings;
  uint64_t objects = 0;
  std::map<std::string, uint64_t> observations;  //!< by class: used
  std::map<std::string, uint64_t> ignored;   //!< by class: no range measurement, or not asked for
  std::map<std::string, uint64_t> rejected;  //!< by class and reason
  points::RejectCounts rejects;              //!< values of observations, by reason
  uint64_t repeated_stamps = 0;
  uint64_t backward_stamps = 0;
  uint64_t bad_stamps = 0;
  uint64_t scans = 0;                            //!< decoded
  double first_stamp_s = 0;                      //!< of the first scan, since 1970
  double last_stamp_s = 0;                       //!< of the last one
  uint64_t points = 0;                           //!< decoded
  std::map<std::string, uint64_t> deskew;        //!< scans by what was done
  std::map<std::string, uint64_t> pose_quality;  //!< scans by how their pose was found
  std::map<std::string, uint64_t> poses;         //!< PoseTrack's report
  std::string pose_source;
  std::map<std::string, std::string> pose_notes;   //!< what the source has to say
  std::map<std::string, uint64_t> poses_rejected;  //!< by class and reason
  std::vector<MapMetrics> maps;
  std::vector<logs::SensorTimes> sensors;  //!< for the report; not in metrics.json
  std::vector<SnapshotMetrics> snapshots;
  std::vector<std::string> files;
  StageTimes times;
};

/** Highest resident memory of this process and its waited-for children so far, MB. */
double peakMemory_mb();

/** The metrics as JSON text. */
std::string toJson(const RunMetrics& metrics);

/** What toJson() wrote of a piece, with all that addPiece() needs. Takes any bytes; throws
 * formats::FormatError where they are no metrics of a piece, or damaged. */
RunMetrics pieceFromJson(const std::string& text);

/** Adds a piece's counts to those of the pieces before it. */
void addPiece(RunMetrics& sum, const RunMetrics& piece);
}  // namespace traverse::app
