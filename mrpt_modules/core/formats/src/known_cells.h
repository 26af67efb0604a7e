// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/layers/layer_set.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace traverse::formats
{
/** Throws std::invalid_argument where a layer has another number of cells than the extent. */
void checkSizes(const layers::LayerSet& set);

/** Whether a value says anything: not NaN, no code 0. */
template <class T>
bool isKnown(T value)
{
  if constexpr (std::is_floating_point_v<T>)
  {
    return !std::isnan(value);
  }
  else
  {
    return value != 0;
  }
}

/** Places (row-major) of the cells of which any layer says anything, ascending. */
std::vector<size_t> knownCells(const layers::LayerSet& set);

/** Column and row of a place. */
geometry::CellIndex cellAt(const layers::LayerSet& set, size_t place);

/** Height of a cell for drawing, m: the map's mean height, else that of its ground, else 0. */
class CellHeight
{
 public:
  explicit CellHeight(const layers::LayerSet& set);
  double at(size_t place) const;

 private:
  std::vector<const std::vector<float>*> sources_;
};

/** Code of a cell in the class layer, 0 where there is none. */
class CellClass
{
 public:
  explicit CellClass(const layers::LayerSet& set);

  uint8_t at(size_t place) const { return codes_ == nullptr ? uint8_t{0} : (*codes_)[place]; }

  const layers::LegendEntry& entry(uint8_t code) const { return entries_[code]; }

 private:
  const std::vector<uint8_t>* codes_ = nullptr;
  std::array<layers::LegendEntry, 256> entries_;  // without legend: no name, grey
};

/** Names of the layers as fields of other formats: letters, digits and '_', never `reserved`, each
 * once whatever the case of its letters. */
std::vector<std::string> fieldNames(
    const layers::LayerSet& set, const std::vector<std::string>& reserved);
}  // namespace traverse::formats
