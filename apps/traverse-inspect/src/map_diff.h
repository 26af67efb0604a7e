// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/common_app/json_text.h>

#include <filesystem>

namespace traverse::app
{
/** What two maps may differ by and still count as the same. */
struct DiffTolerance
{
  double value = 0;  //!< of each layer's values, in its unit; classes and counts: 0 all the same
  double cells = 0;  //!< share of the cells known in either map, 0..1
};

/** Compares the maps of two output folders, or two archives, layer by layer on the absolute
 * lattice; what lies outside a map is unknown in it. Member "same" says whether all layers agree.
 *
 * Throws formats::FormatError where one cannot be read, or the folders have different numbers of
 * maps. */
Json diffJson(
    const std::filesystem::path& a, const std::filesystem::path& b, const DiffTolerance& tolerance);

/** That object for people. */
std::string diffText(const Json& diff);
}  // namespace traverse::app
