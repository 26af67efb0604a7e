// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/lattice.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace traverse::layers
{
/** One named quantity per cell, row-major from the cell of smallest x and y; unknown is NaN in
 * floating layers and the layer's own code (0 = undefined) in class layers. */
struct Layer
{
  std::string name;  //!< also the file's name: "traversability_class"
  std::string unit;  //!< "m", "deg", "1" ...
  std::variant<std::vector<uint8_t>, std::vector<uint32_t>, std::vector<float>, std::vector<double>>
      data;
};

/** A colour of pictures and legends. */
struct Colour
{
  uint8_t r = 0, g = 0, b = 0;
};

/** Meaning and colour of one code of a class layer. */
struct LegendEntry
{
  uint8_t code = 0;
  std::string name;
  Colour colour;
};

/** Layers on one geometry: what a map shows of itself to pictures, files and the navigator. */
struct LayerSet
{
  geometry::Lattice lattice;
  geometry::CellRect extent;  //!< which cells the rows and columns are
  std::vector<Layer> layers;
  std::string class_layer;  //!< name of the layer that pictures show
  std::vector<LegendEntry> legend;
  std::vector<uint8_t> blocked_codes = {4};  //!< of the class layer: where nothing drives

  /** nullptr where there is no such layer. */
  const Layer* find(std::string_view name) const;

  size_t size() const
  {
    return static_cast<size_t>(extent.width()) * static_cast<size_t>(extent.height());
  }
};

/** Which layers somebody wants: all, or those of these names. */
struct LayerChoice
{
  std::optional<std::vector<std::string>> names;

  bool has(std::string_view name) const
  {
    return !names || std::find(names->begin(), names->end(), name) != names->end();
  }
};

/** How many cells each entry of the legend has, in its order. */
std::vector<std::pair<std::string, uint64_t>> cellsByClass(const LayerSet& set);
}  // namespace traverse::layers
