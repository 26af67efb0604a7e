// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "read_scans.h"

#include <traverse/common_app/interrupt.h>
#include <traverse/common_app/progress.h>
#include <traverse/logs/log_reader.h>

namespace traverse::app
{
logs::LogReport readScans(
    const std::filesystem::path& log, bool quiet, const std::function<void(points::Decoded)>& give)
{
  observations::ObservationParams sensors;
  sensors.max_range_m = 100'000;  // wrong units are to be seen
  logs::ReadOptions options;
  options.stop = &Interrupt::flag();
  options.accept_bad_stamps = true;
  logs::LogReader reader(log, {}, sensors, options);
  Progress progress("reading", "scans", quiet);
  uint64_t scans = 0;
  while (auto decoded = reader.next())
  {
    const logs::LogReport& report = reader.report();
    progress.show(
        static_cast<double>(report.bytes_read) /
            static_cast<double>(std::max<uint64_t>(1, report.file_size)),
        ++scans);
    give(std::move(*decoded));
  }
  progress.finish(scans);
  return reader.report();
}
}  // namespace traverse::app
