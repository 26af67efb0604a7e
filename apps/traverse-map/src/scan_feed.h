// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "settings.h"

#include <traverse/logs/log_reader.h>
#include <traverse/points/deskew.h>
#include <traverse/poses/pose_track.h>

#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

namespace traverse::app
{
/** A scan as the maps take it. */
struct PreparedScan
{
  points::Decoded decoded;
  std::optional<points::Deskew> deskew;  //!< nothing where [traverse-map] deskew = false
  double read_s = 0;
  double deskew_s = 0;
  double fraction_read = 0;  //!< of the log
};

/** The scans of a log in file order, deskewed; with threads > 1 in a thread of their own that runs
 * a few scans ahead. At most max_scans of them. */
class ScanFeed
{
 public:
  /** All three must outlive it; the reader is the feed's own as long as it lives. */
  ScanFeed(logs::LogReader& reader, const Settings& settings, const poses::PoseTrack& track);
  ~ScanFeed();
  ScanFeed(const ScanFeed&) = delete;
  ScanFeed& operator=(const ScanFeed&) = delete;

  /** Nothing when it is over. Throws what reading threw, after the scans before. */
  std::optional<PreparedScan> next();

 private:
  std::optional<PreparedScan> prepare();
  void runAhead(const std::stop_token& stop);

  logs::LogReader& reader_;
  const Settings& settings_;
  const poses::PoseTrack& track_;
  uint64_t prepared_ = 0;

  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::deque<PreparedScan> ready_;
  bool over_ = false;
  std::exception_ptr error_;
  std::jthread ahead_;
};
}  // namespace traverse::app
