// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "notes.h"

namespace traverse::ros_bags
{
namespace
{
constexpr size_t kMostKeys = 256;
constexpr size_t kLongestText = 200;
constexpr const char* kOthers = "others";
}  // namespace

std::string shown(const std::string& untrusted)
{
  std::string clean = untrusted.substr(0, kLongestText);
  for (char& c : clean)
  {
    c = c < ' ' || c > '~' ? '?' : c;
  }
  return clean;
}

void Notes::count(std::map<std::string, uint64_t>& counts, const std::string& key, uint64_t n)
{
  const std::string clean = shown(key);
  const bool room = counts.size() < kMostKeys || counts.count(clean) > 0;
  counts[room ? clean : kOthers] += n;
}

void Notes::warn(const std::string& text)
{
  const std::string clean = shown(text);
  if (told_.size() < kMostKeys && told_.insert(clean).second)
  {
    report_.warnings.push_back(clean);
  }
}

void Notes::damage(const std::string& text)
{
  if (report_.damage.size() < kMostKeys)
  {
    report_.damage.push_back(shown(text));
  }
}
}  // namespace traverse::ros_bags
