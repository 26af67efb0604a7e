// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/options/option.h>

#include <functional>
#include <string>
#include <vector>

namespace traverse::plugin
{
/** One ini section of a map: [<maps section>_<map name>_<index>_<suffix>]. */
struct SectionSchema
{
  std::string suffix;
  std::string meaning;
  std::vector<options::Row> rows;  //!< every key with its default

  /** Throws config::ConfigError where the section has no such key, or it does not take the value.
   */
  std::function<void(const std::string& section, const std::string& key, const std::string& value)>
      check;
};

/** What a map's sections may hold, for reference.ini, the options tables and the check of section
 * names. */
struct MapSchema
{
  std::string name;                  //!< as in `name`_count
  std::vector<std::string> aliases;  //!< other names that MRPT's factory knows it by
  std::vector<SectionSchema> sections;
};

/** All maps of this library. */
std::vector<MapSchema> mapSchemas();
}  // namespace traverse::plugin
