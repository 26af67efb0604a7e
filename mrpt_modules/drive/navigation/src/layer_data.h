// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/layers/layer_set.h>

#include <cstddef>
#include <string_view>
#include <variant>
#include <vector>

namespace traverse::navigation
{
/** nullptr where the set has no such layer, or one of other values. */
template <class Value>
const std::vector<Value>* dataOf(const layers::LayerSet& set, std::string_view name)
{
  const layers::Layer* layer = set.find(name);
  return layer == nullptr ? nullptr : std::get_if<std::vector<Value>>(&layer->data);
}

inline double valueOf(const layers::Layer& layer, size_t cell)
{
  return std::visit([&](const auto& data) { return static_cast<double>(data[cell]); }, layer.data);
}
}  // namespace traverse::navigation
