// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace traverse::testing
{
/** The bytes, up to the first character that is none of base64. */
inline std::string fromBase64(const std::string& base64)
{
  std::string bytes;
  uint32_t bits = 0;
  int have = 0;
  for (const char c : base64)
  {
    const size_t digit =
        std::string("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/").find(c);
    if (digit == std::string::npos)
    {
      break;
    }
    bits = (bits << 6U) | static_cast<uint32_t>(digit);
    have += 6;
    if (have >= 8)
    {
      have -= 8;
      bytes += static_cast<char>((bits >> static_cast<unsigned>(have)) & 0xFFU);
    }
  }
  return bytes;
}
}  // namespace traverse::testing
