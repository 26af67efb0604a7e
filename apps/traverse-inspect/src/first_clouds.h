// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scan_census.h"

#include <filesystem>
#include <string>
#include <vector>

namespace traverse::app
{
/** Draws the first cloud of each sensor from above and in perspective, coloured by height, into a
 * folder that is made where it is not there. Returns the files. Throws formats::FileError, and
 * rendering::RenderError where nothing can be drawn. */
std::vector<std::filesystem::path> drawFirstClouds(
    const ScanCensus& census, const std::filesystem::path& folder);
}  // namespace traverse::app
