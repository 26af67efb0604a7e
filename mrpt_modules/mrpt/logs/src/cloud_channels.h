// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/formats/point_channels.h>
#include <traverse/points/decoded.h>
#include <traverse/sandbox/input_file.h>

#include <filesystem>
#include <optional>
#include <string>

namespace mrpt::obs
{
class CObservation;
}  // namespace mrpt::obs

namespace traverse::logs
{
/** Ring and time of a log's clouds, from the file beside it (formats/point_channels.h). */
class CloudChannels
{
 public:
  /** A log without such a file is as good as any. */
  explicit CloudChannels(const std::filesystem::path& log);

  /** What cannot be read of the file; empty where nothing is wrong, or there is none. */
  const std::string& damage() const { return damage_; }

  /** Completes the scan of a CObservationPointCloud that has none of its own. Returns what became
   * of it in a few words; empty where there is no file, or the observation is no cloud. */
  std::string attach(const mrpt::obs::CObservation& observation, points::ScanBuffer& scan) const;

 private:
  sandbox::Fd fd_;
  std::optional<formats::ChannelsReader> reader_;
  std::string damage_;
};
}  // namespace traverse::logs
