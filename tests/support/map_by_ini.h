// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/plugin/register.h>

#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/maps/CMultiMetricMap.h>

#include <exception>
#include <string>

#ifdef TRAVERSE_SANITIZED
// MRPT holds a map's definition by a bare pointer while it loads, and forgets it when loading
// throws: one leak per refused ini, none of ours to mend.
extern "C" __attribute__((used)) inline const char*
__lsan_default_suppressions()  // NOLINT(bugprone-reserved-identifier)
{
  return "leak:TSetOfMetricMapInitializers::loadFromConfigFile";
}
#endif

// Maps made as stock MRPT programs make them: by the factory, from section [map] of an ini.
namespace traverse::testing
{
/** The section of an ini that asks for one map, before the sections of its options. */
inline const std::string kOneGrid = "[map]\nCTraversabilityGridMap_count = 1\n";

inline void build(mrpt::maps::CMultiMetricMap& map, const std::string& ini)
{
  plugin::registerAllMaps();
  mrpt::config::CConfigFileMemory file(ini);
  mrpt::maps::TSetOfMetricMapInitializers definitions;
  definitions.loadFromConfigFile(file, "map");
  map.setListOfMaps(definitions);
}

/** What MRPT's factory says of the ini, or "accepted". */
inline std::string refusal(const std::string& ini)
{
  mrpt::maps::CMultiMetricMap map;
  try
  {
    build(map, ini);
  }
  catch (const std::exception& e)
  {
    return e.what();
  }
  return "accepted";
}
}  // namespace traverse::testing
