// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "overlap.h"

#include <algorithm>
#include <stdexcept>
#include <variant>

namespace traverse::navigation
{
std::vector<Overlap::Run> Overlap::runs(const Axis& theirs, const Axis& ours)
{
  const int64_t from_mm = std::max(theirs.min * theirs.cell_mm, ours.min * ours.cell_mm);
  const int64_t to_mm = std::min(theirs.max * theirs.cell_mm, ours.max * ours.cell_mm);
  std::vector<Run> all;
  for (int64_t at_mm = from_mm; at_mm < to_mm;)
  {
    const int64_t their_cell = geometry::floorDiv(at_mm, theirs.cell_mm);
    const int64_t our_cell = geometry::floorDiv(at_mm, ours.cell_mm);
    const auto their_place = static_cast<size_t>(their_cell - theirs.min);
    const auto our_place = static_cast<size_t>(our_cell - ours.min);
    if (!all.empty() && their_place == all.back().theirs + all.back().length &&
        our_place == all.back().ours + all.back().length)
    {
      ++all.back().length;
    }
    else
    {
      all.push_back({their_place, our_place, 1});
    }
    at_mm = std::min((their_cell + 1) * theirs.cell_mm, (our_cell + 1) * ours.cell_mm);
  }
  return all;
}

Overlap::Overlap(
    const layers::LayerSet& set,
    const geometry::Lattice& lattice,
    const geometry::CellRect& extent) :
    their_width_(static_cast<size_t>(std::max(set.extent.width(), 0))),
    our_width_(static_cast<size_t>(std::max(extent.width(), 0)))
{
  if (set.lattice.cell_mm <= 0 || lattice.cell_mm <= 0)
  {
    throw std::invalid_argument("cells must be 1 mm wide at least");
  }
  if (set.extent.empty() || extent.empty())
  {
    return;
  }
  for (const layers::Layer& layer : set.layers)
  {
    const size_t cells = std::visit([](const auto& data) { return data.size(); }, layer.data);
    if (cells != set.size())
    {
      throw std::invalid_argument("layer " + layer.name + " has not as many cells as its map");
    }
  }
  columns_ = runs(
      {set.lattice.cell_mm, set.extent.min.x, set.extent.max.x},
      {lattice.cell_mm, extent.min.x, extent.max.x});
  rows_ = runs(
      {set.lattice.cell_mm, set.extent.min.y, set.extent.max.y},
      {lattice.cell_mm, extent.min.y, extent.max.y});
}
}  // namespace traverse::navigation
