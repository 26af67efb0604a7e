// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace traverse::formats
{
/** A finite number, all of the text, in any locale; nothing for anything else. */
std::optional<double> parseNumber(std::string_view text);

/** Seconds as decimal text ("1305031102.175304", "1.036224e-01") to nanoseconds, exactly; digits
 * beyond the ninth are rounded, halves away from zero. Nothing for what is no number, or beyond
 * the 292 years of 64 bits. */
std::optional<int64_t> parseSecondsAsNs(std::string_view text);
}  // namespace traverse::formats
