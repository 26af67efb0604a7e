// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "notes.h"

namespace traverse::ros_bags
{
namespace
{
constexpr size_t kMostKeys = 256;
constexpr size_t kLongestText = 200;
}  // namespace

void Notes::warn(const std::string& text)
{
  const std::string clean = options::printable(text, kLongestText);
  if (told_.size() < kMostKeys && told_.insert(clean).second)
  {
    report_.warnings.push_back(clean);
  }
}

void Notes::damage(const std::string& text)
{
  if (report_.damage.size() < kMostKeys)
  {
    report_.damage.push_back(options::printable(text, kLongestText));
  }
}
}  // namespace traverse::ros_bags
