// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/logs/log_reader.h>

#include <support/scratch_folder.h>
#include <support/synthetic_logs.h>
#include <utility>
#include <vector>

namespace traverse::testing
{
/** All that a log gives. */
struct LogReading
{
  std::vector<points::Decoded> scans;
  logs::LogReport report;

  size_t points() const
  {
    size_t n = 0;
    for (const points::Decoded& d : scans)
    {
      n += d.scan.size();
    }
    return n;
  }
};

inline LogReading readLog(
    const std::filesystem::path& file,
    const observations::ObservationParams& sensors = {},
    const logs::ReadOptions& options = {})
{
  logs::LogReader reader(file, {}, sensors, options);
  LogReading reading;
  while (auto decoded = reader.next())
  {
    reading.scans.push_back(std::move(*decoded));
  }
  reading.report = reader.report();
  return reading;
}

inline LogReading readLogBytes(
    const std::string& bytes,
    const observations::ObservationParams& sensors = {},
    const logs::ReadOptions& options = {})
{
  const ScratchFolder dir;
  writeText(dir / "some.rawlog", bytes);
  return readLog(dir / "some.rawlog", sensors, options);
}
}  // namespace traverse::testing
