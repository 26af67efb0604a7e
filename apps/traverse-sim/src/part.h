// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/simulation/recording.h>

#include <cstdint>
#include <string>
#include <vector>

namespace traverse::app
{
/** So much of a recording is made, and kept, at once. */
inline constexpr double kPartSeconds = 5;

/** Events of a part of a recording, as they are written. */
struct Part
{
  std::string log;  //!< a gzip member

  /** Of each turn of a lidar, in the log's order: of each point, label + 65536 x object. */
  std::vector<std::vector<uint32_t>> labels;
};

/** Makes these events, in their order, with so many threads; the result does not depend on their
 * number. Ends early, with nothing that can be used, where `stop` says so. Throws what making one
 * of them throws. */
Part makePart(
    const simulation::Recording& recording,
    const simulation::RecordingParams& params,
    const std::vector<simulation::Recording::Planned>& events,
    int threads);

/** A part's labels as bytes, and back. Throws formats::FormatError. */
std::string labelBytes(const std::vector<std::vector<uint32_t>>& labels);
std::vector<std::vector<uint32_t>> labelsIn(const std::string& bytes, const std::string& name);
}  // namespace traverse::app
