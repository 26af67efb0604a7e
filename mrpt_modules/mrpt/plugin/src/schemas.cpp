// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/config/creation_params.h>
#include <traverse/maps/CTraversabilityGridMap.h>
#include <traverse/plugin/schemas.h>

namespace traverse::plugin
{
std::vector<MapSchema> mapSchemas()
{
  const maps::CTraversabilityGridMap::TMapDefinition traversability;
  return {
      {"CTraversabilityGridMap",
       {{"creationOpts", "What MRPT may do with the map.", options::rows(config::CreationParams{})},
        {"insertOpts", "Cells, extent and classes: doc/maps/traversability_grid.md.",
         options::rows(traversability.insertionOpts)},
        {"likelihoodOpts", "How well a scan fits the map.",
         options::rows(traversability.likelihoodOpts)},
        {"renderOpts", "How the map is drawn.", options::rows(traversability.render_opts)}}}};
}
}  // namespace traverse::plugin
