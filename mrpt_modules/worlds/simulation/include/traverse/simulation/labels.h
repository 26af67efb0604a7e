// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace traverse::simulation
{
/** What a surface is; the numbers stand in truth files. */
enum class Label : uint16_t
{
  none = 0,  //!< nothing real: rain, a false return
  ground = 1,
  road = 2,
  pavement = 3,  //!< and the kerb that leads to it
  rut = 4,
  ditch = 5,
  bank = 6,  //!< of snow or soil
  lump = 7,  //!< clods of snow or soil, stones
  grass = 8,
  bush = 9,
  tree = 10,
  building = 11,
  wall = 12,
  fence = 13,
  pole = 14,
  vehicle = 15,
  person = 16,
  structure = 17,  //!< bridges, gates, tables: what may be driven under
  thing = 18,      //!< boxes, prisms, spheres of a scene file that say no more
};

inline constexpr size_t kLabels = 19;

std::string_view nameOf(Label label);

/** What a surface is made of; the numbers stand in truth files. */
enum class Material : uint8_t
{
  soil = 0,
  asphalt = 1,
  concrete = 2,
  brick = 3,
  snow = 4,
  ice = 5,
  grass = 6,  //!< gives way to a vehicle
  foliage = 7,
  wood = 8,
  metal = 9,
  glass = 10,
  cloth = 11,
};

inline constexpr size_t kMaterials = 12;

std::string_view nameOf(Material material);

/** Share of the light of 905 nm that comes back from a surface met at a right angle, 0..1; rough
 * values of the literature on lidar reflectivities, for intensities and ranges. */
double reflectivityOf(Material material);

/** True where a vehicle drives through it. */
constexpr bool yields(Material material)
{
  return material == Material::grass;
}
}  // namespace traverse::simulation
