// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace traverse::formats
{
/** What LZF compressed, exactly `size` bytes. Throws FormatError where the input is damaged, gives
 * another number of bytes, or could never give so many. */
std::string lzfDecompress(std::string_view input, size_t size);
}  // namespace traverse::formats
