// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/common_app/progress.h>
#include <traverse/formats/gif.h>
#include <traverse/formats/output_folder.h>
#include <traverse/nav_app/closed_loop.h>

#include <cstdint>
#include <optional>

namespace traverse::app
{
/** Says how far a drive is, and films it where [traverse-nav] frames_every_s asks for it. */
class Watcher
{
 public:
  Watcher(const NavSettings& settings, bool quiet);

  void see(const Pilot& pilot, const DriveResult& so_far);

  /** Writes drive.gif where there are pictures. Throws formats::FileError. */
  void finish(formats::OutputFolder& folder);

 private:
  const NavSettings& settings_;
  Progress progress_;
  uint64_t steps_ = 0;
  std::optional<formats::AnimatedGif> film_;
  double next_frame_s_ = 0;
};
}  // namespace traverse::app
