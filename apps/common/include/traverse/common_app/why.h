// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace traverse::app
{
/** "X,Y" as two finite numbers of at most 1,000 km, metres; nothing for any other text. */
std::optional<std::array<double, 2>> parsePlace(std::string_view text);

/** What each map of an output folder says of its cell at a place of the map frame, as lines
 * `key: value`, a blank line between maps. Throws formats::FormatError where the folder has no map,
 * or one that cannot be read. */
std::string why(const std::filesystem::path& folder, const std::array<double, 2>& place_m);
}  // namespace traverse::app
