// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ini_sections.h"

#include <traverse/simulation/scene_params.h>

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <vector>

namespace traverse::simulating
{
namespace
{
using config::ConfigError;
using simulation::numberedSection;

/** "Object_07" is 7; throws where there is no whole number behind the prefix. */
size_t numberOf(
    const config::IniDocument& ini, const std::string& section, const std::string& prefix)
{
  const std::string_view digits = std::string_view(section).substr(prefix.size());
  size_t number = 0;
  const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const bool whole = error == std::errc{} && stop == digits.data() + digits.size();
  if (!whole || !config::sameName(section, numberedSection(prefix, number)))
  {
    throw ConfigError(
        fmt::format(
            "{}section [{}]: allowed: {}, {} ...", placeOf(ini, section), section,
            numberedSection(prefix, 0), numberedSection(prefix, 1)),
        section);
  }
  return number;
}

/** Whether MRPT's reader gives the text back as it is. */
bool standsInIni(const std::string& text)
{
  const bool printable = std::all_of(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) >= ' '; });
  const bool blanks = !text.empty() && (text.front() == ' ' || text.back() == ' ');
  return printable && !blanks && text.find("//") == std::string::npos &&
         text.find('$') == std::string::npos && text.find('@') == std::string::npos &&
         (text.empty() || text.back() != '\\');
}
}  // namespace

bool beginsWith(std::string_view section, std::string_view prefix)
{
  return section.size() >= prefix.size() &&
         config::sameName(section.substr(0, prefix.size()), prefix);
}

std::string placeOf(const config::IniDocument& ini, std::string_view section)
{
  const auto entry = std::find_if(
      ini.entries().begin(), ini.entries().end(),
      [&](const config::Entry& e) { return config::sameName(e.section, section); });
  return entry == ini.entries().end() ? "" : entry->place + ": ";
}

size_t countNumbered(const config::IniDocument& ini, const std::string& prefix)
{
  std::vector<size_t> numbers;
  for (const std::string& section : ini.sections())
  {
    if (beginsWith(section, prefix))
    {
      numbers.push_back(numberOf(ini, section, prefix));
    }
  }
  std::sort(numbers.begin(), numbers.end());
  for (size_t i = 0; i < numbers.size(); ++i)
  {
    if (numbers[i] != i)
    {
      const std::string section = numberedSection(prefix, i);
      const std::string there = numberedSection(prefix, numbers[i]);
      throw ConfigError(
          fmt::format("{}there is a section [{}] but no [{}]", placeOf(ini, there), there, section),
          section);
    }
  }
  return numbers.size();
}

std::string keyLine(const std::string& section, std::string_view key, const std::string& value)
{
  if (!standsInIni(value))
  {
    throw ConfigError(
        fmt::format(
            "[{}] {}: this text cannot stand in an ini file (no //, $, @, line ends, blanks at its "
            "ends)",
            section, key),
        section, std::string(key));
  }
  return fmt::format("{} = {}\n", key, value);
}
}  // namespace traverse::simulating
