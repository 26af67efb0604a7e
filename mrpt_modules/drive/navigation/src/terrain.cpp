// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/navigation/terrain.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace traverse::navigation
{
void Terrain::set(const Costmap& costmap)
{
  const geometry::CellRect& extent = costmap.extent;
  const size_t cells =
      extent.empty() ? 0
                     : static_cast<size_t>(extent.width()) * static_cast<size_t>(extent.height());
  if (costmap.passage.size() != cells || costmap.price.size() != cells ||
      costmap.lattice.cell_mm <= 0)
  {
    throw std::invalid_argument("a costmap whose cells are not as many as its extent's");
  }
  lattice_ = costmap.lattice;
  extent_ = extent;
  least_ = {lattice_.edge_m(extent.min.x), lattice_.edge_m(extent.min.y)};
  most_ = {lattice_.edge_m(extent.max.x), lattice_.edge_m(extent.max.y)};
  stride_ = cells == 0 ? 0 : static_cast<size_t>(extent.width()) + 2;
  highest_ = kLeastPrice;
  price_.assign(cells == 0 ? 0 : stride_ * (static_cast<size_t>(extent.height()) + 2), kClosed);
  const auto columns = static_cast<size_t>(std::max(0, extent.width()));
  for (size_t k = 0; k < cells; ++k)
  {
    const Passage passage = costmap.passage[k];
    if (passage == Passage::open || (passage == Passage::unknown && costmap.is_unknown_planned))
    {
      open((k / columns + 1) * stride_ + k % columns + 1, costmap.price[k]);
    }
  }
}

void Terrain::open(size_t index, float price)
{
  if (std::isfinite(price))
  {
    price_[index] = std::clamp(price, kLeastPrice, kMostPrice);
    highest_ = std::max(highest_, price_[index]);
  }
}

geometry::CellIndex Terrain::cell(size_t index) const
{
  return {
      static_cast<int32_t>(index % stride_) - 1 + extent_.min.x,
      static_cast<int32_t>(index / stride_) - 1 + extent_.min.y};
}

Place Terrain::centre(size_t index) const
{
  const geometry::CellIndex c = cell(index);
  return {lattice_.centre_m(c.x), lattice_.centre_m(c.y)};
}

double Terrain::mean() const
{
  double sum = 0;
  size_t cells = 0;
  for (const float price : price_)
  {
    if (price < kClosed)
    {
      sum += double{price};
      ++cells;
    }
  }
  return cells == 0 ? double{kLeastPrice} : sum / static_cast<double>(cells);
}

double Terrain::priceOfLine(Place from, Place to) const
{
  double sum = 0;
  const bool is_open = overCells(
      from, to, lattice_,
      [&](geometry::CellIndex c, double share)
      {
        const size_t index = indexOf(c);
        if (!isOpen(index))
        {
          return false;
        }
        sum += share * double{price_[index]};
        return true;
      });
  const double dx = to.x_m - from.x_m;
  const double dy = to.y_m - from.y_m;
  return is_open ? sum * std::sqrt(dx * dx + dy * dy) : std::numeric_limits<double>::infinity();
}
}  // namespace traverse::navigation
