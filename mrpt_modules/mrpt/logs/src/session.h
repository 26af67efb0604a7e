// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "log_file.h"
#include "reader_process.h"
#include "sensor_census.h"
#include "wire.h"

#include <traverse/logs/log_report.h>

#include <filesystem>
#include <optional>
#include <variant>

namespace traverse::logs
{
/** The parent's side: starts the child, takes and checks its frames, keeps the report. */
class Session
{
 public:
  /** Throws LogError. */
  Session(
      const std::filesystem::path& file,
      const LogParams& params,
      const ReadOptions& options,
      const ReaderJob& job);

  using Product = std::variant<points::Decoded, poses::StampedPose>;

  /** The next scan or pose; nothing when it is over, and the report says how. */
  std::optional<Product> next();

  const LogReport& report() const { return report_; }

 private:
  struct Frame
  {
    FrameType type = FrameType::end;
    std::span<const uint8_t> payload;
  };

  bool frameComplete() const;
  Frame takeFrame();
  bool waitForFrame();
  std::optional<Product> take(const Frame& frame);
  void count(const CountFrame& count);
  void over(LogEnd end, const std::string& why);
  std::string place() const;

  std::filesystem::path file_;
  ReadOptions options_;
  LogFile log_;
  LogReport report_;
  SensorCensus census_;
  ReaderProcess process_;
  std::vector<uint8_t> received_;
  size_t used_ = 0;
  bool ended_well_ = false;
};
}  // namespace traverse::logs
