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

std::vector<std::pair<std::string, uint64_t>> cellsByClass(const LayerSet& set)
{
  std::vector<std::pair<std::string, uint64_t>> counts;
  counts.reserve(set.legend.size());
  for (const LegendEntry& entry : set.legend)
  {
    counts.emplace_back(entry.name, 0);
  }
  const Layer* classes = set.find(set.class_layer);
  const auto* codes =
      classes == nullptr ? nullptr : std::get_if<std::vector<uint8_t>>(&classes->data);
  for (size_t i = 0; codes != nullptr && i < codes->size(); ++i)
  {
    for (size_t k = 0; k < set.legend.size(); ++k)
    {
      counts[k].second += static_cast<uint64_t>(set.legend[k].code == (*codes)[i]);
    }
  }
  return counts;
}
}  // namespace traverse::layers
