// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "patch_grid.h"

#include <traverse/ground/estimator.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace traverse::ground
{
using geometry::floorDiv;
using geometry::floorMod;

void PatchGrid::reset(
    std::span<const Column> columns,
    const geometry::Lattice& lattice,
    const geometry::CellRect& window,
    double patch_m)
{
  layOut(lattice, window, patch_m);
  clear();
  countColumns(columns);
  putColumns(columns);
}

void PatchGrid::layOut(
    const geometry::Lattice& lattice, const geometry::CellRect& window, double patch_m)
{
  window_ = window;
  cell_m_ = lattice.cell_m();
  cells_ = cellsAlongPatch(patch_m, lattice);
  side_m_ = static_cast<float>(cell_m_ * cells_);
  const auto patch = [&](int32_t cell) { return static_cast<int32_t>(floorDiv(cell, cells_)); };
  first_ = {patch(window.min.x), patch(window.min.y)};
  patch_columns_ = patch(window.max.x - 1) - first_.x + 1;
  patch_rows_ = patch(window.max.y - 1) - first_.y + 1;
  stride_ = patch_columns_ + 2 * kBorder;
  if (int64_t{stride_} * (patch_rows_ + 2 * kBorder) > Estimator::kMostPatches)
  {
    throw std::length_error("a ground estimate of more than 100 million patches");
  }
  along_ = alongPatch();
  placesOf(window.min.x, window.max.x, by_x_);
  placesOf(window.min.y, window.max.y, by_y_);
}

std::vector<PatchGrid::Along> PatchGrid::alongPatch() const
{
  std::vector<Along> all;
  for (int32_t c = -1; c <= cells_; ++c)
  {
    Along a;
    a.offset_m = (static_cast<float>(c) + 0.5F) * cell_m() - side_m_ / 2;
    const int32_t twice = 2 * c + 1 - cells_;  // from the patch's middle, in half cells
    a.lower = twice < 0 ? -1 : 0;
    a.part =
        static_cast<float>(twice < 0 ? twice + 2 * cells_ : twice) / static_cast<float>(2 * cells_);
    a.patch = static_cast<int32_t>(floorDiv(c, cells_));
    a.cell = static_cast<int32_t>(floorMod(c, cells_));
    all.push_back(a);
  }
  return all;
}

void PatchGrid::placesOf(int32_t min, int32_t max, std::vector<Place>& places) const
{
  Place p{kBorder, static_cast<uint16_t>(floorMod(min, cells_))};
  places.resize(static_cast<size_t>(max - min));
  for (Place& place : places)
  {
    place = p;
    const bool is_last = ++p.cell == cells_;
    p.patch += is_last ? 1 : 0;
    p.cell = is_last ? 0 : p.cell;
  }
}

/** No plane and no column anywhere, and all of the window open. */
void PatchGrid::clear()
{
  const auto size = static_cast<size_t>(stride_) * static_cast<size_t>(patch_rows_ + 2 * kBorder);
  patches_.assign(size, {});
  is_open_.assign(size, 0);
  for (int32_t row = 0; row < patch_rows_; ++row)
  {
    const auto begin = is_open_.begin() + patchAt(0, row);
    std::fill(begin, begin + patch_columns_, 1);
  }
}

/** Finds the patches with columns, and which columns are whose. */
void PatchGrid::countColumns(std::span<const Column> columns)
{
  blocks_.clear();
  block_of_.resize(columns.size());
  for (size_t i = 0; i < columns.size(); ++i)
  {
    const geometry::CellIndex cell = columns[i].cell;
    const int32_t patch = by_y_[static_cast<size_t>(cell.y - window_.min.y)].patch * stride_ +
                          by_x_[static_cast<size_t>(cell.x - window_.min.x)].patch;
    int32_t& block = at(patch).block;
    if (block < 0)
    {
      block = static_cast<int32_t>(blocks_.size());
      blocks_.push_back({patch, 0, 0});
    }
    ++blocks_[static_cast<size_t>(block)].size;
    block_of_[i] = block;
  }
  uint32_t first = 0;
  for (Block& block : blocks_)
  {
    block.first = first;
    first += block.size;
  }
}

void PatchGrid::putColumns(std::span<const Column> columns)
{
  columns_.resize(columns.size());
  slots_.assign(slotOf(static_cast<int32_t>(blocks_.size()), 0, 0), -1);
  for (size_t i = 0; i < columns.size(); ++i)
  {
    const Column& c = columns[i];
    const uint16_t x = by_x_[static_cast<size_t>(c.cell.x - window_.min.x)].cell;
    const uint16_t y = by_y_[static_cast<size_t>(c.cell.y - window_.min.y)].cell;
    const uint32_t put = blocks_[static_cast<size_t>(block_of_[i])].first++;
    columns_[put] = {
        c.low_m, c.mean_m, c.top_m, c.highest_m, c.noise_m, c.n, static_cast<uint32_t>(i), x, y};
    slots_[slotOf(block_of_[i], x, y)] = static_cast<int32_t>(put);
  }
  for (Block& block : blocks_)
  {
    block.first -= block.size;
  }
}

int32_t PatchGrid::patchAt(int32_t column, int32_t row) const
{
  const bool inside = column >= 0 && row >= 0 && column < patch_columns_ && row < patch_rows_;
  return inside ? (row + kBorder) * stride_ + column + kBorder : -1;
}

PatchGrid::Position PatchGrid::positionOf(double x_m, double y_m) const
{
  const double edge_m = cell_m_ * cells_;
  return {
      static_cast<float>(x_m / edge_m - first_.x - 0.5),
      static_cast<float>(y_m / edge_m - first_.y - 0.5)};
}
}  // namespace traverse::ground
