// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "settings.h"

#include <string>
#include <vector>

namespace traverse::app
{
/** Reads section [Maps] into settings.maps (ours) and `stock` (MRPT's own, left to MRPT's programs,
 * with a warning). A name that nobody knows, a count outside 0..16, and no map at all throw
 * ConfigError. */
void readWantedMaps(Settings& settings, std::vector<WantedMap>& stock);

/** Holds every key and value in the sections of a wanted map against what the map takes. Throws
 * ConfigError with file:line. */
void checkMapSections(const WantedMap& map, const config::IniDocument& ini);

/** Names of the ini sections that belong to a wanted map. */
std::vector<std::string> mapSections(const WantedMap& map);
}  // namespace traverse::app
