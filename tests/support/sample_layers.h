// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/layers/layer_set.h>

#include <string>
#include <utility>
#include <vector>

namespace traverse::testing
{
/** Class layer as drawn: the first line is the row of largest y; '.' undefined, digits are codes.
 * The lower left cell is `corner`. */
inline layers::LayerSet drawnClasses(
    const std::vector<std::string>& rows, geometry::CellIndex corner = {}, int32_t cell_mm = 200)
{
  layers::LayerSet set;
  set.lattice.cell_mm = cell_mm;
  const auto width = static_cast<int32_t>(rows.front().size());
  const auto height = static_cast<int32_t>(rows.size());
  set.extent = {corner, {corner.x + width, corner.y + height}};
  std::vector<uint8_t> codes;
  for (size_t row = rows.size(); row-- > 0;)
  {
    for (const char c : rows[row])
    {
      codes.push_back(c == '.' ? uint8_t{0} : static_cast<uint8_t>(c - '0'));
    }
  }
  set.class_layer = "traversability_class";
  set.layers.push_back({set.class_layer, "1", std::move(codes)});
  set.legend = {
      {0, "undefined", {160, 160, 160}},
      {1, "flat", {40, 80, 200}},
      {2, "small roughness", {190, 150, 220}},
      {3, "large roughness", {200, 20, 60}},
      {4, "obstacle", {250, 220, 40}}};
  return set;
}
}  // namespace traverse::testing
