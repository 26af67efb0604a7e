// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace traverse::testing
{
/** What a shell command prints, both streams. */
inline std::string outputOf(const std::string& command)
{
  std::string text;
  FILE* pipe = ::popen(("(" + command + ") 2>&1 </dev/null").c_str(), "r");
  std::array<char, 4096> part{};
  while (pipe != nullptr)
  {
    const size_t got = std::fread(part.data(), 1, part.size(), pipe);
    text.append(part.data(), got);
    if (got == 0)
    {
      ::pclose(pipe);
      break;
    }
  }
  return text;
}
}  // namespace traverse::testing
