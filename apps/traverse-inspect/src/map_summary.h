// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/common_app/json_text.h>

#include <filesystem>
#include <string>

namespace traverse::app
{
/** What the maps of an output folder (or one archive) are, and how the run went that made them, if
 * its metrics are there. Throws formats::FormatError. */
Json mapsJson(const std::filesystem::path& folder_or_file);

/** That object for people. */
std::string mapsText(const Json& maps);
}  // namespace traverse::app
