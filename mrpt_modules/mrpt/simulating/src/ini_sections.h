// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/config/ini_document.h>
#include <traverse/options/option.h>

#include <cstddef>
#include <string>
#include <string_view>

// What sections of scene files have in common, read and written.
namespace traverse::simulating
{
/** Without case. */
bool beginsWith(std::string_view section, std::string_view prefix);

/** "file:line: " of the section's first key; empty where the ini has no such section. */
std::string placeOf(const config::IniDocument& ini, std::string_view section);

/** How many [prefixNN] there are. Throws ConfigError, with file and line, where they are not
 * numbered 00, 01 ... without a gap. */
size_t countNumbered(const config::IniDocument& ini, const std::string& prefix);

/** A key as a line of an ini. Throws ConfigError where the text cannot stand in one. */
std::string keyLine(const std::string& section, std::string_view key, const std::string& value);

/** A section with every key of p. Throws ConfigError as keyLine(). */
template <class P>
std::string wholeSection(const std::string& section, const P& p)
{
  std::string text = "\n[" + section + "]\n";
  for (const options::Row& row : options::rows(p))
  {
    text += keyLine(section, row.key, row.value);
  }
  return text;
}
}  // namespace traverse::simulating
