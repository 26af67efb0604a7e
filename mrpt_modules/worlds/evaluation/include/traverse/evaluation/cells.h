// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/layers/layer_set.h>

#include <optional>
#include <string_view>
#include <vector>

namespace traverse::evaluation
{
/** Looks at one layer by absolute cells. */
template <class T>
class CellView
{
 public:
  /** Of no cells. */
  CellView() = default;

  CellView(const layers::LayerSet& set, const std::vector<T>& cells) :
      extent_(set.extent), cells_(&cells)
  {
  }

  /** The cell's value; `outside` where the layer does not reach. */
  T at(geometry::CellIndex c, T outside = {}) const
  {
    return cells_ != nullptr && extent_.contains(c) ? (*cells_)[indexOf(c)] : outside;
  }

  const geometry::CellRect& extent() const { return extent_; }

  size_t size() const { return cells_ == nullptr ? 0 : cells_->size(); }

  /** Row by row; of a cell of the extent. */
  size_t indexOf(geometry::CellIndex c) const
  {
    return static_cast<size_t>(c.y - extent_.min.y) * static_cast<size_t>(extent_.width()) +
           static_cast<size_t>(c.x - extent_.min.x);
  }

 private:
  geometry::CellRect extent_;
  const std::vector<T>* cells_ = nullptr;
};

/** Throws std::invalid_argument where the layer is missing, of another type, or not of the
 * extent's size. */
template <class T>
CellView<T> viewOf(const layers::LayerSet& set, std::string_view layer);

extern template CellView<uint8_t> viewOf<uint8_t>(const layers::LayerSet&, std::string_view);
extern template CellView<uint32_t> viewOf<uint32_t>(const layers::LayerSet&, std::string_view);
extern template CellView<float> viewOf<float>(const layers::LayerSet&, std::string_view);

/** Throws std::invalid_argument where the two do not lie on one lattice. */
void checkLattice(const layers::LayerSet& map, const layers::LayerSet& truth);

/** Calls visit(CellIndex) for every cell, row by row. */
template <class Visit>
void forEachCell(const geometry::CellRect& rect, Visit&& visit)
{
  for (int32_t y = rect.min.y; y < rect.max.y; ++y)
  {
    for (int32_t x = rect.min.x; x < rect.max.x; ++x)
    {
      visit(geometry::CellIndex{x, y});
    }
  }
}
}  // namespace traverse::evaluation
