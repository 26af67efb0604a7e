// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "command_line.h"
#include "metrics.h"

#include <filesystem>

namespace traverse::app
{
/** Makes the output folder of a whole log from those of all its pieces (command.merge). Its
 * archives are, byte for byte, those of a run over the log in one go. Returns the folder; nothing
 * where there was no scan in any piece, or somebody interrupted.
 *
 * Throws config::ConfigError where the pieces were made with different options, or do not fit in
 * max_memory_mb together, and formats::FormatError where a folder is not complete, damaged,
 * missing, there twice, or of another log. */
std::filesystem::path mergeFolders(const Command& command, RunMetrics& metrics);
}  // namespace traverse::app
