// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/observations/cause.h>

#include <algorithm>

namespace traverse::observations
{
std::string causeOf(const std::exception& e)
{
  constexpr size_t kLongest = 160;
  const std::string text = e.what();
  const std::string mark = "Message:";
  const size_t at = text.find(mark);
  const size_t begin =
      text.find_first_not_of(" \t\r\n", at == std::string::npos ? 0 : at + mark.size());
  if (begin == std::string::npos)
  {
    return "";
  }
  return text.substr(begin, std::min(text.find_first_of("\r\n", begin) - begin, kLongest));
}
}  // namespace traverse::observations
