// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/simulation/labels.h>

#include <array>

namespace traverse::simulation
{
namespace
{
constexpr std::array<std::string_view, kLabels> kLabelNames = {
    "none", "ground",  "road",   "pavement",  "rut",      "ditch", "bank",
    "lump", "grass",   "bush",   "tree",      "building", "wall",  "fence",
    "pole", "vehicle", "person", "structure", "thing"};

struct MaterialRow
{
  std::string_view name;
  double reflectivity;
};

constexpr std::array<MaterialRow, kMaterials> kMaterialRows = {
    {{"soil", 0.3},
     {"asphalt", 0.17},
     {"concrete", 0.35},
     {"brick", 0.4},
     {"snow", 0.8},
     {"ice", 0.3},
     {"grass", 0.4},
     {"foliage", 0.5},
     {"wood", 0.4},
     {"metal", 0.5},
     {"glass", 0.1},
     {"cloth", 0.5}}};
}  // namespace

std::string_view nameOf(Label label)
{
  return kLabelNames.at(static_cast<size_t>(label));
}

std::string_view nameOf(Material material)
{
  return kMaterialRows.at(static_cast<size_t>(material)).name;
}

double reflectivityOf(Material material)
{
  return kMaterialRows.at(static_cast<size_t>(material)).reflectivity;
}
}  // namespace traverse::simulation
