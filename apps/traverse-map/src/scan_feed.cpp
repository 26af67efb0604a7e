// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_feed.h"

#include <chrono>
#include <utility>

namespace traverse::app
{
namespace
{
constexpr size_t kMostReady = 4;

double fractionRead(const logs::LogReport& report)
{
  return report.file_size == 0
             ? 0.0
             : static_cast<double>(report.bytes_read) / static_cast<double>(report.file_size);
}

/** Runs `work`; its time goes to `seconds`. */
template <class Work>
auto timed(double& seconds, Work&& work)
{
  const auto start = std::chrono::steady_clock::now();
  auto result = work();
  seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}
}  // namespace

ScanFeed::ScanFeed(
    logs::LogReader& reader, const Settings& settings, const poses::PoseTrack& track) :
    reader_(reader), settings_(settings), track_(track)
{
  if (settings.run.threads > 1)
  {
    ahead_ = std::jthread([this](const std::stop_token& stop) { runAhead(stop); });
  }
}

ScanFeed::~ScanFeed()
{
  if (ahead_.joinable())  // before the members that it uses go
  {
    ahead_.request_stop();
    ahead_.join();
  }
}

std::optional<PreparedScan> ScanFeed::next()
{
  if (settings_.run.threads == 1)
  {
    return prepare();
  }
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return over_ || !ready_.empty(); });
  if (ready_.empty())
  {
    if (error_)
    {
      std::rethrow_exception(std::exchange(error_, nullptr));
    }
    return std::nullopt;
  }
  PreparedScan scan = std::move(ready_.front());
  ready_.pop_front();
  changed_.notify_all();
  return scan;
}

std::optional<PreparedScan> ScanFeed::prepare()
{
  const auto most = static_cast<uint64_t>(settings_.run.max_scans);
  if (most > 0 && prepared_ >= most)
  {
    return std::nullopt;
  }
  PreparedScan scan;
  auto decoded = timed(scan.read_s, [&] { return reader_.next(); });
  if (!decoded)
  {
    return std::nullopt;
  }
  scan.decoded = std::move(*decoded);
  if (settings_.run.deskew)
  {
    scan.deskew = timed(scan.deskew_s, [&] { return points::deskew(scan.decoded.scan, track_); });
  }
  scan.fraction_read = fractionRead(reader_.report());
  ++prepared_;
  return scan;
}

void ScanFeed::runAhead(const std::stop_token& stop)
{
  try
  {
    std::optional<PreparedScan> scan = prepare();
    for (; scan && !stop.stop_requested(); scan = prepare())
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, stop, [this] { return ready_.size() < kMostReady; });
      ready_.push_back(std::move(*scan));
      changed_.notify_all();
    }
  }
  catch (...)
  {
    const std::scoped_lock lock(mutex_);
    error_ = std::current_exception();
  }
  const std::scoped_lock lock(mutex_);
  over_ = true;
  changed_.notify_all();
}
}  // namespace traverse::app
