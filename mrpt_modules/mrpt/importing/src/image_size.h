// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace traverse::importing
{
/** Looks at the first bytes of a PNG or JPEG file: what a decoder would believe and allocate.
 * Throws ImportError where it is neither, or its sides are not of 1 to 16384 pixels. */
void checkPicture(const std::filesystem::path& file);
}  // namespace traverse::importing
