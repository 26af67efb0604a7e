// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <support/sample_layers.h>
#include <vector>

// Maps and truths drawn as text, to be compared.
namespace traverse::testing
{
using Drawn = std::vector<std::string>;

/** A map of these classes with as many returns as the digits of the second drawing say. */
inline layers::LayerSet mapOf(
    const Drawn& classes, const Drawn& returns, geometry::CellIndex corner = {})
{
  layers::LayerSet map = drawnClasses(classes, corner);
  const layers::LayerSet counted = drawnClasses(returns, corner);
  const auto& digits = std::get<std::vector<uint8_t>>(counted.layers[0].data);
  map.layers.push_back({"point_count", "1", std::vector<uint32_t>(digits.begin(), digits.end())});
  return map;
}

inline layers::LayerSet truthOf(const Drawn& classes, geometry::CellIndex corner = {})
{
  layers::LayerSet truth = drawnClasses(classes, corner);
  truth.class_layer = "truth_class";
  truth.layers[0].name = "truth_class";
  return truth;
}

/** Adds a layer of bytes of which the drawing's digits are the values. */
inline void addDrawn(layers::LayerSet& set, const std::string& name, const Drawn& drawn)
{
  set.layers.push_back({name, "1", drawnClasses(drawn).layers[0].data});
}

/** The same of 32 bits. */
inline void addDrawnNumbers(layers::LayerSet& set, const std::string& name, const Drawn& drawn)
{
  const layers::LayerSet digits = drawnClasses(drawn);
  const auto& bytes = std::get<std::vector<uint8_t>>(digits.layers[0].data);
  set.layers.push_back({name, "1", std::vector<uint32_t>(bytes.begin(), bytes.end())});
}
}  // namespace traverse::testing
