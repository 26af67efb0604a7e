// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/config/strict.h>

#include <algorithm>
#include <cctype>
#include <fmt/format.h>

namespace traverse::config
{
std::string lowerCase(std::string_view text)
{
  std::string lower(text);
  std::transform(
      lower.begin(), lower.end(), lower.begin(),
      [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

std::string unknownKey(
    std::string_view section, std::string_view key, const std::vector<std::string>& known)
{
  const std::string near = options::nearest(lowerCase(key), known);
  const std::string hint = near.empty() ? fmt::format("known: {}", fmt::join(known, ", "))
                                        : fmt::format("did you mean '{}'?", near);
  return fmt::format("[{}] unknown key '{}'; {}", section, key, hint);
}

void checkSectionNames(
    const mrpt::config::CConfigFileBase& ini,
    const std::string& prefix,
    const std::vector<std::string>& endings)
{
  std::vector<std::string> sections;
  ini.getAllSections(sections);
  for (const std::string& section : sections)
  {
    if (!sameName(section.substr(0, prefix.size()), prefix))
    {
      continue;
    }
    const std::string ending = section.substr(prefix.size());
    const bool known = std::any_of(
        endings.begin(), endings.end(), [&](const std::string& e) { return sameName(e, ending); });
    if (!known)
    {
      throw ConfigError(
          fmt::format(
              "section [{}] is none of this map's; they end in {}", section,
              fmt::join(endings, ", ")),
          section);
    }
  }
}
}  // namespace traverse::config
