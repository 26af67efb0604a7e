// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How MRPT's map factory makes the map from an ini.
#include <traverse/config/creation_params.h>
#include <traverse/config/strict.h>
#include <traverse/maps/CWrappableMultiLidarGrid.h>

#include <mrpt/config/CConfigFileBase.h>

// The first name must be the class's own: the factory looks definitions up by it.
MAP_DEFINITION_REGISTER(
    "traverse::maps::CWrappableMultiLidarGrid,CWrappableMultiLidarGrid,wrappableMultiLidarGrid",
    traverse::maps::CWrappableMultiLidarGrid)

namespace traverse::maps
{
CWrappableMultiLidarGrid::TMapDefinition::TMapDefinition() = default;

void CWrappableMultiLidarGrid::TMapDefinition::loadFromConfigFile_map_specific(
    const mrpt::config::CConfigFileBase& source, const std::string& prefix)
{
  config::checkSectionNames(
      source, prefix, {"_creationOpts", "_insertOpts", "_likelihoodOpts", "_renderOpts"});
  config::CreationParams read_by_mrpt;
  config::load(source, prefix + "_creationOpts", read_by_mrpt);
  config::load(source, prefix + "_insertOpts", insertionOpts);
  config::load(source, prefix + "_likelihoodOpts", likelihoodOpts);
  config::load(source, prefix + "_renderOpts", render_opts);
  config::load(source, "Vehicle", vehicle);
  config::load(source, "Sensors", sensors);
  std::string section = prefix + "_insertOpts";
  try
  {
    multi_lidar_grid::check(insertionOpts, vehicle);
    section = "Sensors";
    observations::checkTogether(sensors);
  }
  catch (const options::OptionError& e)
  {
    throw config::ConfigError("section " + section + ": " + e.what());
  }
}

void CWrappableMultiLidarGrid::TMapDefinition::dumpToTextStream_map_specific(
    std::ostream& out) const
{
  dumpOptions(out, "insertOpts", insertionOpts);
  dumpOptions(out, "likelihoodOpts", likelihoodOpts);
  dumpOptions(out, "renderOpts", render_opts);
  dumpOptions(out, "Vehicle", vehicle);
  dumpOptions(out, "Sensors", sensors);
}

mrpt::maps::CMetricMap* CWrappableMultiLidarGrid::internal_CreateFromMapDefinition(
    const mrpt::maps::TMetricMapInitializer& def)
{
  const auto& own = dynamic_cast<const TMapDefinition&>(def);
  auto map = std::make_unique<CWrappableMultiLidarGrid>(own.insertionOpts, own.vehicle);
  map->likelihoodOptions = own.likelihoodOpts;
  map->renderOptions = own.render_opts;
  map->sensors = own.sensors;
  return map.release();
}
}  // namespace traverse::maps
