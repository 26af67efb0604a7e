// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/lattice.h>
#include <traverse/simulation/scene.h>

#include <cstdint>
#include <vector>

namespace traverse::simulation
{
/** Sub-squares along an edge of a cell. */
inline constexpr int kSubsPerCell = 4;

/** Cells of an area, each divided into 4 x 4 sub-squares, row by row from the smallest x and y. */
struct SubGrid
{
  geometry::Lattice lattice;
  geometry::CellRect extent;

  int width() const { return extent.width() * kSubsPerCell; }

  int height() const { return extent.height() * kSubsPerCell; }

  size_t size() const { return static_cast<size_t>(width()) * static_cast<size_t>(height()); }

  size_t at(int column, int row) const
  {
    return static_cast<size_t>(row) * static_cast<size_t>(width()) + static_cast<size_t>(column);
  }

  double sub_m() const { return lattice.cell_m() / kSubsPerCell; }

  double minX_m() const { return lattice.edge_m(extent.min.x); }

  double minY_m() const { return lattice.edge_m(extent.min.y); }

  /** Middle of a column (row) of sub-squares, m in the map frame; also outside the grid. */
  double middleX_m(int column) const { return minX_m() + (column + 0.5) * sub_m(); }

  double middleY_m(int row) const { return minY_m() + (row + 0.5) * sub_m(); }
};

/** The grid of all cells that lie in the area whole; std::length_error where they are too many. */
SubGrid subGridOf(const Area& area, int32_t cell_mm);

/** The terrain at the middle of every sub-square. Where nothing is sharp it is interpolated between
 * the cells' middles. */
struct GroundSamples
{
  std::vector<float> height_m;
  std::vector<float> base_m;
  std::vector<float> ditch_m;
  std::vector<uint8_t> label;
};

GroundSamples sampleGround(const Terrain& terrain, const SubGrid& grid);

/** How high the smooth ground climbs in one go up to each sub-square: the sum of the rises along a
 * row or a column that ends there, each of them steeper than max_rise (m per sub-square); 0 where
 * the ground is no steeper. */
std::vector<float> climbs(const std::vector<float>& base_m, const SubGrid& grid, float max_rise_m);

/** 1 for the sub-squares that can be reached from around the start without entering one of which
 * the climb is higher than max_climb_m. */
std::vector<uint8_t> reachable(
    const std::vector<float>& climb_m,
    const SubGrid& grid,
    float max_climb_m,
    const Eigen::Vector2d& start);
}  // namespace traverse::simulation
