// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <string>

namespace traverse::sandbox
{
/** A page that the child writes and the parent reads at any time, also after the child's death.
 * Whatever stands there is a hint for messages, never trusted. */
struct SharedProgress
{
  std::atomic<uint64_t> object = 0;          //!< number of the entry that is being read, from 0
  std::atomic<uint64_t> offset = 0;          //!< byte of the file
  std::array<std::atomic<char>, 64> type{};  //!< class that is being read

  void setType(const std::string& name)
  {
    for (size_t i = 0; i < type.size(); ++i)
    {
      type[i].store(i < name.size() ? name[i] : '\0', std::memory_order_relaxed);
    }
  }

  std::string typeText() const
  {
    std::string text;
    for (const auto& c : type)
    {
      const char letter = c.load(std::memory_order_relaxed);
      if (letter < ' ' || letter > '~')
      {
        break;
      }
      text += letter;
    }
    return text;
  }
};
}  // namespace traverse::sandbox
