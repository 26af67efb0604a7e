// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "metrics.h"
#include "settings.h"

#include <traverse/common_app/map_set.h>
#include <traverse/logs/log_reader.h>
#include <traverse/poses/pose_track.h>

#include <vector>

namespace traverse::app
{
/** The entries of a piece: N runs of a log's entries, as equal as they can be, one behind the
 * other. The last one has no end, so that it meets what is damaged there. */
logs::EntryRange entriesOf(const Piece& piece, uint64_t log_entries);

/** Throws config::ConfigError where pieces of the log would not make the map of the whole: a map
 * that forgets by the order of scans, or max_scans. */
void checkPieces(const Settings& settings, const std::vector<BuiltMap>& maps);

/** What tells the piece of this run from others; counts the log's entries where metrics.log_entries
 * does not say them. Throws formats::FileError and logs::LogError. */
PieceMetrics describePiece(
    const Settings& settings, const poses::PoseTrack& track, const RunMetrics& metrics);
}  // namespace traverse::app
