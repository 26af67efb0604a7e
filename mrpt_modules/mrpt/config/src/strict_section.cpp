// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/config/strict_section.h>

#include <mrpt/config/CConfigFileBase.h>

#include <algorithm>
#include <fmt/format.h>

namespace traverse::config
{
namespace
{
std::string didYouMean(const std::string& word, const std::vector<std::string>& known)
{
  const std::string nearest = options::nearest(word, known);
  return nearest.empty() ? std::string() : fmt::format("; did you mean '{}'?", nearest);
}
}  // namespace

void readSection(
    const mrpt::config::CConfigFileBase& file,
    const std::string& section,
    const std::vector<std::string>& known,
    const SetKey& set)
{
  if (!file.sectionExists(section))
  {
    return;
  }
  std::vector<std::string> keys;
  file.getAllKeys(section, keys);
  for (const std::string& key : keys)
  {
    const std::string text = file.read_string(section, key, "");
    bool is_known = false;
    try
    {
      is_known = set(key, text);
    }
    catch (const options::OptionError& e)
    {
      throw SectionError(fmt::format("section [{}]: {}", section, e.what()));
    }
    if (!is_known)
    {
      throw SectionError(fmt::format(
          "section [{}]: unknown key {} = '{}'{}", section, key, text, didYouMean(key, known)));
    }
  }
}

void checkSectionNames(
    const mrpt::config::CConfigFileBase& file,
    const std::string& prefix,
    const std::vector<std::string>& endings)
{
  std::vector<std::string> sections;
  file.getAllSections(sections);
  for (const std::string& section : sections)
  {
    if (section.compare(0, prefix.size(), prefix) != 0)
    {
      continue;
    }
    const std::string ending = section.substr(prefix.size());
    if (std::find(endings.begin(), endings.end(), ending) == endings.end())
    {
      throw SectionError(fmt::format(
          "section [{}] is none of this map's{}", section, didYouMean(ending, endings)));
    }
  }
}
}  // namespace traverse::config
