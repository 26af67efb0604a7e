// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "snapshots.h"
#include "truth_folder.h"

#include <traverse/evaluation/ghosts.h>

#include <optional>

namespace traverse::app
{
/** How long the map of that file keeps obstacles where moving things were; nothing without its
 * snapshots or moving things. Throws formats::FormatError for a snapshot that cannot be read, or
 * lies on cells of another size. */
std::optional<evaluation::GhostScore> ghostsOf(
    const std::string& map, const std::vector<Snapshot>& snapshots, const TruthFolder& truth);
}  // namespace traverse::app
