// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "patch_grid.h"

#include <traverse/ground/estimator.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace traverse::ground
{
using geometry::CellIndex;
using geometry::floorDiv;

void PatchGrid::reset(
    std::span<const Column> columns,
    const geometry::Lattice& lattice,
    const geometry::CellRect& window,
    double patch_m)
{
  window_ = window;
  cell_m_ = lattice.cell_m();
  cells_ = std::max(1, static_cast<int32_t>(std::lround(patch_m / cell_m_)));
  side_m_ = static_cast<float>(cell_m_ * cells_);
  const auto patch = [&](int32_t cell) { return static_cast<int32_t>(floorDiv(cell, cells_)); };
  first_ = {patch(window.min.x), patch(window.min.y)};
  columns_ = patch(window.max.x - 1) - first_.x + 1;
  rows_ = patch(window.max.y - 1) - first_.y + 1;
  stride_ = columns_ + 2 * kBorder;
  const int64_t size = int64_t{stride_} * (rows_ + 2 * kBorder);
  if (size > Estimator::kMostPatches)
  {
    throw std::length_error("a ground estimate of more than 100 million patches");
  }
  by_x_ = placesOf(window.min.x, window.max.x, first_.x);
  by_y_ = placesOf(window.min.y, window.max.y, first_.y);

  Patch outside;
  outside.state = Patch::State::border;
  patches_.assign(static_cast<size_t>(size), outside);
  for (int32_t row = 0; row < rows_; ++row)
  {
    const auto begin = patches_.begin() + patchAt(0, row);
    std::fill(begin, begin + columns_, Patch{});
  }
  putColumns(columns);
}

std::vector<PatchGrid::Place> PatchGrid::placesOf(int32_t min, int32_t max, int32_t first) const
{
  std::vector<Place> places;
  places.reserve(static_cast<size_t>(max - min));
  for (int32_t c = min; c < max; ++c)
  {
    Place p;
    p.patch = static_cast<int32_t>(floorDiv(c, cells_)) - first;
    p.cell = static_cast<int32_t>(geometry::floorMod(c, cells_));
    const int32_t twice = 2 * p.cell + 1 - cells_;  // from the patch's middle, in half cells
    p.lower = twice < 0 ? p.patch - 1 : p.patch;
    p.part =
        static_cast<float>(twice < 0 ? twice + 2 * cells_ : twice) / static_cast<float>(2 * cells_);
    places.push_back(p);
  }
  return places;
}

void PatchGrid::putColumns(std::span<const Column> columns)
{
  const size_t block_size = blockSize();
  slots_.clear();
  for (size_t i = 0; i < columns.size(); ++i)
  {
    const CellIndex cell = columns[i].cell;
    Patch& patch = at(patchOf(cell));
    if (patch.block < 0)
    {
      patch.block = static_cast<int32_t>(slots_.size() / block_size);
      slots_.resize(slots_.size() + block_size, -1);
    }
    const int32_t inside = by_y_[static_cast<size_t>(cell.y - window_.min.y)].cell * cells_ +
                           by_x_[static_cast<size_t>(cell.x - window_.min.x)].cell;
    slots_[static_cast<size_t>(patch.block) * block_size + static_cast<size_t>(inside)] =
        static_cast<int32_t>(i);
  }
}

std::span<const int32_t> PatchGrid::columnsOf(const Patch& patch) const
{
  const size_t block_size = blockSize();
  return patch.block < 0
             ? std::span<const int32_t>()
             : std::span(slots_).subspan(static_cast<size_t>(patch.block) * block_size, block_size);
}

int32_t PatchGrid::patchAt(int32_t column, int32_t row) const
{
  const bool inside = column >= 0 && row >= 0 && column < columns_ && row < rows_;
  return inside ? (row + kBorder) * stride_ + column + kBorder : -1;
}

int32_t PatchGrid::columnAt(int32_t x, int32_t y) const
{
  if (!window_.contains({x, y}))
  {
    return -1;
  }
  const Place& column = by_x_[static_cast<size_t>(x - window_.min.x)];
  const Place& row = by_y_[static_cast<size_t>(y - window_.min.y)];
  const Patch& patch = at((row.patch + kBorder) * stride_ + column.patch + kBorder);
  const size_t block_size = blockSize();
  return patch.block < 0 ? -1
                         : slots_
                               [static_cast<size_t>(patch.block) * block_size +
                                static_cast<size_t>(row.cell * cells_ + column.cell)];
}

PatchGrid::Position PatchGrid::positionOf(double x_m, double y_m) const
{
  const double edge_m = cell_m_ * cells_;
  return {
      static_cast<float>(x_m / edge_m - first_.x - 0.5),
      static_cast<float>(y_m / edge_m - first_.y - 0.5)};
}
}  // namespace traverse::ground
