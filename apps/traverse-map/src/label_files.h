// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/common_app/map_set.h>
#include <traverse/points/decoded.h>
#include <traverse/poses/pose_track.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace traverse::app
{
/** A file for each cloud of the run with a label for each of its points: DIR/NNNNNN.label, one
 * uint32 (little endian) per point of the observation's own cloud, in its order: 0 undefined, also
 * for points that were left out, 1 ground, 2 obstacle, 3 overhanging. The layout of SemanticKITTI.
 */
class LabelFiles
{
 public:
  /** Throws formats::FileError where DIR has files; with `force`, where they are not those of an
   * earlier run, whose labels go when the first new ones come. */
  LabelFiles(std::filesystem::path folder, bool force);

  /** Writes the next cloud's file with the labels of the first map that gives any. Throws
   * formats::FileError, and config::ConfigError where no map does. */
  void write(
      const points::Decoded& decoded,
      const poses::PoseTrack& track,
      const std::vector<BuiltMap>& maps);

 private:
  void begin();

  std::filesystem::path folder_;
  uint64_t number_ = 0;
};

/** The bytes of a label file: `labels` of the kept points put back in the order of the cloud that
 * they come from. */
std::string labelBytes(const points::Decoded& decoded, const std::vector<uint32_t>& labels);
}  // namespace traverse::app
