// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/common_app/wanted_maps.h>
#include <traverse/config/ini_document.h>
#include <traverse/layers/scan_consumer.h>

#include <mrpt/maps/CMultiMetricMap.h>

#include <string>
#include <vector>

namespace traverse::app
{
/** One map of a run. */
struct BuiltMap
{
  std::string name;         //!< as in the ini
  std::string file_suffix;  //!< "" for the first of its name, "_01", "_02" ... after it
  mrpt::maps::CMetricMap::Ptr map;
  layers::ScanConsumer* consumer = nullptr;  //!< the same object

  /** What messages and metrics call it. */
  std::string title() const { return name + file_suffix; }
};

/** The map's cells. */
geometry::Lattice latticeOf(const BuiltMap& map);

/** Makes the wanted maps of an ini with MRPT's own factory. A map that was asked for and not
 * built is an error: throws config::ConfigError, with the line of the ini where it is known. */
std::vector<BuiltMap> buildMaps(
    const config::IniDocument& ini, const std::vector<WantedMap>& wanted);
}  // namespace traverse::app
