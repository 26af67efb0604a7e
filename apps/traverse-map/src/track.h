// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "metrics.h"
#include "settings.h"

#include <traverse/poses/pose_track.h>

#include <atomic>

namespace traverse::app
{
/** The poses of the run, from where the ini says. Reads the log once where they are in it. What was
 * met goes to `metrics`. Throws logs::LogError where the log cannot be read at all, and
 * formats::FormatError for a trajectory file. */
poses::PoseTrack makeTrack(
    const Settings& settings, RunMetrics& metrics, const std::atomic<bool>& stop);
}  // namespace traverse::app
