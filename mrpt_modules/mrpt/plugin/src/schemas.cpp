// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/config/creation_params.h>
#include <traverse/config/strict.h>
#include <traverse/maps/CTraversabilityGridMap.h>
#include <traverse/maps/CWrappableMultiLidarGrid.h>
#include <traverse/plugin/schemas.h>

namespace traverse::plugin
{
namespace
{
template <class P>
SectionSchema schemaOf(const std::string& suffix, const std::string& meaning, const P& defaults)
{
  return {
      suffix, meaning, options::rows(defaults),
      [defaults](const std::string& section, const std::string& key, const std::string& value)
      {
        P scratch = defaults;
        config::setStrictly(scratch, section, key, value);
      }};
}

MapSchema traversabilityGrid()
{
  const maps::CTraversabilityGridMap::TMapDefinition traversability;
  return {
      "CTraversabilityGridMap",
      {"traversabilityGridMap", "traverse::maps::CTraversabilityGridMap"},
      {schemaOf("creationOpts", "What MRPT may do with the map.", config::CreationParams{}),
       schemaOf(
           "insertOpts", "Cells, extent and classes: doc/maps/traversability_grid.md.",
           traversability.insertionOpts),
       schemaOf("likelihoodOpts", "How well a scan fits the map.", traversability.likelihoodOpts),
       schemaOf("renderOpts", "How the map is drawn.", traversability.render_opts),
       schemaOf(
           "octomapOpts", "An OctoMap of all points beside the cells: doc/output.md.",
           traversability.octomap_opts)}};
}

MapSchema multiLidarGrid()
{
  const maps::CWrappableMultiLidarGrid::TMapDefinition multi_lidar;
  return {
      "CWrappableMultiLidarGrid",
      {"wrappableMultiLidarGrid", "traverse::maps::CWrappableMultiLidarGrid"},
      {schemaOf("creationOpts", "What MRPT may do with the map.", config::CreationParams{}),
       schemaOf(
           "insertOpts", "Cells, sensors, time and buffers: doc/maps/multi_lidar_grid.md.",
           multi_lidar.insertionOpts),
       schemaOf("likelihoodOpts", "How well a scan fits the map.", multi_lidar.likelihoodOpts),
       schemaOf("renderOpts", "How the map is drawn.", multi_lidar.render_opts)}};
}
}  // namespace

std::vector<MapSchema> mapSchemas()
{
  return {traversabilityGrid(), multiLidarGrid()};
}
}  // namespace traverse::plugin
