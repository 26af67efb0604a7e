// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/evaluation/cells.h>

#include <fmt/format.h>
#include <stdexcept>

namespace traverse::evaluation
{
template <class T>
CellView<T> viewOf(const layers::LayerSet& set, std::string_view layer)
{
  const layers::Layer* found = set.find(layer);
  const auto* cells = found == nullptr ? nullptr : std::get_if<std::vector<T>>(&found->data);
  if (cells == nullptr || cells->size() != (set.extent.empty() ? 0 : set.size()))
  {
    throw std::invalid_argument(fmt::format(
        "layer '{}' is {}", layer,
        found == nullptr ? "missing" : "not of the type or size that is compared"));
  }
  return CellView<T>(set, *cells);
}

template CellView<uint8_t> viewOf<uint8_t>(const layers::LayerSet&, std::string_view);
template CellView<uint32_t> viewOf<uint32_t>(const layers::LayerSet&, std::string_view);
template CellView<float> viewOf<float>(const layers::LayerSet&, std::string_view);

void checkLattice(const layers::LayerSet& map, const layers::LayerSet& truth)
{
  if (!(map.lattice == truth.lattice))
  {
    throw std::invalid_argument(fmt::format(
        "the map's cells are of {} mm, those of the truth of {} mm", map.lattice.cell_mm,
        truth.lattice.cell_mm));
  }
}
}  // namespace traverse::evaluation
