// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/layers/layer_set.h>

#include <algorithm>

namespace traverse::layers
{
const Layer* LayerSet::find(std::string_view name) const
{
  const auto found =
      std::find_if(layers.begin(), layers.end(), [&](const Layer& l) { return l.name == name; });
  return found == layers.end() ? nullptr : &*found;
}
}  // namespace traverse::layers
