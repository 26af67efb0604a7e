// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace traverse::formats
{
/** CRC-32 as of zip, gzip and PNG: "123456789" gives 0xCBF43926. */
uint32_t crc32(std::string_view bytes);

/** The same of a file of any size. Throws FileError. */
uint32_t crc32OfFile(const std::filesystem::path& file);
}  // namespace traverse::formats
