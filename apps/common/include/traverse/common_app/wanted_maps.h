// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/config/ini_document.h>

#include <string>
#include <vector>

namespace traverse::app
{
/** A map that an ini asks for: `name`_count = count in section [Maps]. */
struct WantedMap
{
  std::string name;  //!< as in the ini
  int count = 0;
};

/** What section [Maps] asks for. */
struct MapWishes
{
  std::vector<WantedMap> ours;
  std::vector<WantedMap> stock;  //!< MRPT's own, left to MRPT's programs
  std::vector<std::string> warnings;
};

/** Reads section [Maps], and holds every key and value in our maps' sections against what they
 * take. A name that nobody knows, a count outside 0..16, and no map at all throw ConfigError with
 * file:line. */
MapWishes readWantedMaps(const config::IniDocument& ini);

/** Refuses sections that are neither `own` nor of a wanted map: ConfigError with file:line. Those
 * of stock maps are warned of. */
void checkSections(
    const config::IniDocument& ini, const std::vector<std::string>& own, MapWishes& wishes);

/** Names of the ini sections that belong to a wanted map. */
std::vector<std::string> mapSections(const WantedMap& map);
}  // namespace traverse::app
