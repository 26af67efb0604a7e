// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <string_view>

// Text out of logs, archives and messages, which may be anything.
namespace traverse::options
{
/** Its first bytes, with '?' for each that is no printable ASCII. */
inline std::string printable(
    std::string_view untrusted, size_t most_bytes = std::numeric_limits<size_t>::max())
{
  std::string text(untrusted.substr(0, most_bytes));
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return text;
}

/** n more of a kind, by the first 200 printable bytes of its name; from 256 kinds on, new ones
 * count as "others": what hostile input makes up does not fill the memory. */
inline void countBounded(
    std::map<std::string, uint64_t>& counts, std::string_view kind, uint64_t n = 1)
{
  constexpr size_t kMostKinds = 256;
  constexpr size_t kLongest = 200;
  const std::string clean = printable(kind, kLongest);
  const bool room = counts.size() < kMostKinds || counts.count(clean) > 0;
  counts[room ? clean : "others"] += n;
}
}  // namespace traverse::options
