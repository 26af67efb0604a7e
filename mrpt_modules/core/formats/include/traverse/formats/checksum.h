// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string_view>

namespace traverse::formats
{
/** CRC-32 as of zip, gzip and PNG: "123456789" gives 0xCBF43926. */
uint32_t crc32(std::string_view bytes);
}  // namespace traverse::formats
