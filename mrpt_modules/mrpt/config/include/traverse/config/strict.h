// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/config/ini_document.h>
#include <traverse/options/option.h>

#include <mrpt/config/CConfigFileBase.h>

#include <string>
#include <string_view>
#include <vector>

namespace traverse::config
{
/** "[section] unknown key 'x'; did you mean 'y'?" */
std::string unknownKey(
    std::string_view section, std::string_view key, const std::vector<std::string>& known);

/** Lower-case copy (ASCII): our keys are lower case, MRPT compares without case. */
std::string lowerCase(std::string_view text);

template <class P>
std::vector<std::string> keysOf(const P& p)
{
  std::vector<std::string> keys;
  visit(p, [&](const options::Option& o, const auto& /*member*/) { keys.emplace_back(o.key); });
  return keys;
}

/** Sets one option of p; throws ConfigError with section and key where it has none or refuses. */
template <class P>
void setStrictly(P& p, const std::string& section, const std::string& key, const std::string& value)
{
  try
  {
    if (!options::set(p, lowerCase(key), value))
    {
      throw ConfigError(unknownKey(section, key, keysOf(p)), section, key);
    }
  }
  catch (const options::OptionError& e)
  {
    throw ConfigError("[" + section + "] " + e.what(), section, key);
  }
}

/** Loads a section into p. Every key must be known, every value whole and in range. A section that
 * is not there leaves the defaults. Throws ConfigError with file:line. */
template <class P>
void load(const IniDocument& ini, std::string_view section, P& p)
{
  for (const Entry& entry : ini.entries())
  {
    if (sameName(entry.section, section))
    {
      try
      {
        setStrictly(p, entry.section, entry.key, entry.value);
      }
      catch (const ConfigError& e)
      {
        throw ConfigError(entry.place + ": " + e.what(), e.section(), e.key());
      }
    }
  }
}

/** The same from MRPT's reader (no line numbers), for map shells that stock programs create. */
template <class P>
void load(const mrpt::config::CConfigFileBase& ini, const std::string& section, P& p)
{
  std::vector<std::string> keys;
  ini.getAllKeys(section, keys);
  for (const std::string& key : keys)
  {
    setStrictly(p, section, key, ini.read_string(section, key, ""));
  }
}

/** Throws ConfigError where the file has a section that begins with `prefix` but goes on with none
 * of `endings`: a misspelt one would silently do nothing. */
void checkSectionNames(
    const mrpt::config::CConfigFileBase& ini,
    const std::string& prefix,
    const std::vector<std::string>& endings);
}  // namespace traverse::config
