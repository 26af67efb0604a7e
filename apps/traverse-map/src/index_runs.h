// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace traverse::app
{
/** Writes `folder`/index.html, a table of the output folders in it, and returns its path. Folders
 * that are no output of a run are left out; what is damaged or not finished is listed as such. An
 * index.html that is none of ours stays unless `force`.
 *
 * Throws formats::FormatError where the folder cannot be read, formats::FileError where the file
 * cannot be written. */
std::filesystem::path writeIndex(const std::filesystem::path& folder, bool force);
}  // namespace traverse::app
