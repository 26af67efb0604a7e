// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/config/creation_params.h>
#include <traverse/config/strict.h>
#include <traverse/maps/CTraversabilityGridMap.h>
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
}  // namespace

std::vector<MapSchema> mapSchemas()
{
  const maps::CTraversabilityGridMap::TMapDefinition traversability;
  return {
      {"CTraversabilityGridMap",
       {"traversabilityGridMap", "traverse::maps::CTraversabilityGridMap"},
       {schemaOf("creationOpts", "What MRPT may do with the map.", config::CreationParams{}),
        schemaOf(
            "insertOpts", "Cells, extent and classes: doc/maps/traversability_grid.md.",
            traversability.insertionOpts),
        schemaOf("likelihoodOpts", "How well a scan fits the map.", traversability.likelihoodOpts),
        schemaOf("renderOpts", "How the map is drawn.", traversability.render_opts),
        schemaOf(
            "octomapOpts", "An OctoMap of all points beside the cells: doc/output.md.",
            traversability.octomap_opts)}}};
}
}  // namespace traverse::plugin
