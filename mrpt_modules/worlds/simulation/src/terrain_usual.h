// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/simulation/terrain_params.h>

#include <optional>

namespace traverse::simulation
{
/** What a kind of terrain has where the scene file says nothing. 0 of length and width: without
 * end. */
struct UsualTerrain
{
  double length_m = 0;
  double width_m = 0;
  double height_m = 0;
  double edge_m = 0;
  double wavelength_m = 0;
  std::optional<Material> material;
  std::optional<Label> label;
};

inline UsualTerrain usualTerrain(TerrainKind kind)
{
  switch (kind)
  {
    case TerrainKind::hills:
      return {0, 0, 1, 0, 25, {}, {}};
    case TerrainKind::ramp:
      return {5, 0, 0.5, 0, 0, {}, {}};
    case TerrainKind::step:
      return {0, 0, 0.15, 0.01, 0, {}, {}};
    case TerrainKind::kerb:
      return {20, 3, 0.12, 0.02, 0, Material::concrete, Label::pavement};
    case TerrainKind::road:
      return {40, 6, 0, 0, 0, Material::asphalt, Label::road};
    case TerrainKind::ruts:
      return {20, 1.5, 0.07, 0.02, 0, {}, Label::rut};
    case TerrainKind::bank:
      return {20, 0.6, 0.2, 0.08, 0.8, Material::snow, Label::bank};
    case TerrainKind::ditch:
      return {20, 1, 0.6, 0.1, 0, {}, Label::ditch};
    case TerrainKind::hole:
      return {0, 1, 0.4, 0.05, 0, {}, Label::ditch};
    case TerrainKind::roughness:
      return {0, 0, 0.01, 0.5, 0.6, {}, {}};
    case TerrainKind::raster:
      return {};
  }
  return {};
}
}  // namespace traverse::simulation
