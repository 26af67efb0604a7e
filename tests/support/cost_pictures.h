// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/navigation/costmap.h>

#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Layers and costmaps drawn as text, seen from above: the top row has the largest y, the lower left
// cell is (0, 0).
namespace traverse::testing
{
using CostPicture = std::vector<std::string>;

inline constexpr float kNoValue = std::numeric_limits<float>::quiet_NaN();

/** A map without layers whose lower left cell is `corner`. */
inline layers::LayerSet emptyLayers(
    int32_t columns, int32_t rows, int32_t cell_mm, geometry::CellIndex corner = {0, 0})
{
  layers::LayerSet set;
  set.lattice.cell_mm = cell_mm;
  set.extent = {corner, {corner.x + columns, corner.y + rows}};
  return set;
}

/** A layer of codes: the place of each character in `characters`. */
inline layers::LayerSet codeLayer(
    const std::string& name,
    const CostPicture& picture,
    std::string_view characters,
    int32_t cell_mm = 200)
{
  layers::LayerSet set = emptyLayers(
      static_cast<int32_t>(picture.front().size()), static_cast<int32_t>(picture.size()), cell_mm);
  std::vector<uint8_t> codes;
  for (auto row = picture.rbegin(); row != picture.rend(); ++row)
  {
    for (const char c : *row)
    {
      codes.push_back(static_cast<uint8_t>(characters.find(c)));
    }
  }
  set.layers.push_back({name, "1", std::move(codes)});
  return set;
}

/** occupancy_state: ' ' unknown, '.' free, '#' obstacle, 'v' negative, '~' overhang. */
inline layers::LayerSet occupancyOf(const CostPicture& picture, int32_t cell_mm = 200)
{
  return codeLayer("occupancy_state", picture, " .#v~", cell_mm);
}

/** traversability_class: ' ' undefined, '1' to '3', '4' obstacle. */
inline layers::LayerSet classesOf(const CostPicture& picture, int32_t cell_mm = 200)
{
  return codeLayer("traversability_class", picture, " 1234", cell_mm);
}

/** The same value in all cells. */
inline layers::LayerSet& withLayer(layers::LayerSet& set, const std::string& name, float value)
{
  set.layers.push_back({name, "1", std::vector<float>(set.size(), value)});
  return set;
}

/** '.' open, ' ' unknown, 's' soft, 'H' hard, '#' obstacle. */
inline CostPicture passagesOf(const navigation::Costmap& costmap)
{
  CostPicture picture;
  const auto width = static_cast<size_t>(costmap.extent.width());
  for (auto row = static_cast<size_t>(costmap.extent.height()); row-- > 0;)
  {
    std::string line;
    for (size_t column = 0; column < width; ++column)
    {
      line.push_back(". sH#"[static_cast<size_t>(costmap.passage[row * width + column])]);
    }
    picture.push_back(line);
  }
  return picture;
}

/** A vehicle that stands so far away that it opens nothing. */
inline constexpr geometry::Pose2 kFarAway = {1000, 1000, 0};

/** The costmap of maps with the extent of the first, cells of its size, and the vehicle far away.
 */
inline navigation::Costmap costsOf(
    const std::vector<layers::LayerSet>& sets,
    const navigation::CostParams& params,
    const geometry::Pose2& stand = kFarAway)
{
  std::vector<navigation::MapLayers> maps;
  maps.reserve(sets.size());
  for (const layers::LayerSet& set : sets)
  {
    maps.push_back({"map " + std::to_string(maps.size()), &set});
  }
  return navigation::costmapOf(
      maps, sets.front().lattice, sets.front().extent, stand, geometry::Vehicle{}, params);
}

/** No buffers but the obstacles' own cells. */
inline navigation::CostParams withoutBuffers()
{
  navigation::CostParams params;
  params.hard_buffer_m = 0.001;
  params.soft_buffer_m = 0;
  params.strip = layers::StripRule::none;
  return params;
}
}  // namespace traverse::testing
