// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/options/option.h>

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace mrpt::config
{
class CConfigFileBase;
}

namespace traverse::config
{
/** A section of an ini that is not as it should be: the message has section, key, value, what is
 * allowed, and the nearest known key. */
class SectionError : public std::runtime_error
{
 public:
  using std::runtime_error::runtime_error;
};

/** Sets a key from text; false where there is no such key; may throw options::OptionError. */
using SetKey = std::function<bool(const std::string& key, const std::string& text)>;

/** Gives every key of the section to `set`. A section that is not there changes nothing. Throws
 * SectionError for keys that are none of `known` and for values that `set` refuses. */
void readSection(
    const mrpt::config::CConfigFileBase& file,
    const std::string& section,
    const std::vector<std::string>& known,
    const SetKey& set);

/** Throws SectionError where the file has a section that begins with prefix but goes on with none
 * of `endings`: a misspelt one would silently do nothing. */
void checkSectionNames(
    const mrpt::config::CConfigFileBase& file,
    const std::string& prefix,
    const std::vector<std::string>& endings);

/** The keys of an options struct. */
template <class P>
std::vector<std::string> keysOf(const P& params)
{
  std::vector<std::string> keys;
  for (const options::Row& row : options::rows(params))
  {
    keys.push_back(row.key);
  }
  return keys;
}

/** Loads a section strictly, unlike MRPT's reader, which takes "abc" for 0 and ignores what it does
 * not know. */
template <class P>
void loadSection(const mrpt::config::CConfigFileBase& file, const std::string& section, P& params)
{
  P loaded = params;
  readSection(
      file, section, keysOf(loaded),
      [&](const std::string& key, const std::string& text)
      { return options::set(loaded, key, text); });
  params = std::move(loaded);
}
}  // namespace traverse::config
