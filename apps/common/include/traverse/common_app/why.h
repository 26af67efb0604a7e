// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/common_app/exit_code.h>

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace traverse::app
{
/** A place "X,Y" of the map frame: two finite numbers of at most 1,000 km, metres; nothing for any
 * other text. */
std::optional<std::array<double, 2>> placeOf(std::string_view text);

/** Prints what each map of an output folder says of its cell at a place (see placeOf), as lines
 * `key: value`, a blank line between maps. Complains in the name of `program` about any other text.
 * Throws formats::FormatError where the folder has no map, or one that cannot be read. */
ExitCode printWhy(
    const std::string& program, const std::filesystem::path& folder, const std::string& place);
}  // namespace traverse::app
