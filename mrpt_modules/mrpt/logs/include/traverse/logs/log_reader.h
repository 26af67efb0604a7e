// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/logs/log_params.h>
#include <traverse/logs/log_report.h>
#include <traverse/observations/observation_params.h>
#include <traverse/points/decoded.h>

#include <filesystem>
#include <memory>
#include <optional>

namespace traverse::logs
{
/** Reads the scans of a rawlog (plain or gzip; observations or action/sensory-frame pairs) in file
 * order, in a child process: whatever stands in the file, this process neither crashes nor grows.
 *
 * The child is forked from the calling thread and dies with that thread. Not for use by several
 * threads at once; several readers may live side by side. */
class LogReader
{
 public:
  /** Throws LogError where the file cannot be opened, options::OptionError for bad params. */
  LogReader(
      const std::filesystem::path& file,
      const LogParams& params,
      const observations::ObservationParams& sensors,
      const ReadOptions& options = {});
  ~LogReader();
  LogReader(LogReader&&) noexcept;
  LogReader& operator=(LogReader&&) noexcept;

  /** The next scan; nothing when it is over, and report() says how. */
  std::optional<points::Decoded> next();

  /** So far; final once next() gave nothing. */
  const LogReport& report() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/** Walks a log without decoding anything, like LogReader otherwise: report.objects is the number of
 * its entries, up to a damage. Throws LogError. */
LogReport countEntries(
    const std::filesystem::path& file, const LogParams& params, const ReadOptions& options = {});
}  // namespace traverse::logs
