// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace traverse::formats
{
/** The bytes as a gzip file, without name or time: the same bytes give the same file. */
std::string gzip(std::string_view bytes);
}  // namespace traverse::formats
