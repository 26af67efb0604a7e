// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sensor_census.h"
#include "wire.h"

#include <traverse/logs/log_params.h>
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
      const sandbox::ReaderJob& job);

  using Product = std::variant<points::Decoded, poses::StampedPose>;

  /** The next scan or pose; nothing when it is over, and the report says how. */
  std::optional<Product> next();

  const LogReport& report() const { return report_; }

 private:
  std::optional<Product> take(const sandbox::Frame& frame);
  void count(const CountFrame& count);
  void over(LogEnd end, const std::string& why);
  std::string place() const;

  std::filesystem::path file_;
  sandbox::InputFile log_;
  LogReport report_;
  SensorCensus census_;
  sandbox::FrameStream frames_;
  bool ended_well_ = false;
};
}  // namespace traverse::logs
