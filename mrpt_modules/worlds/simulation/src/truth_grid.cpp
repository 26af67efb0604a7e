// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "truth_grid.h"

#include <traverse/simulation/truth.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <stdexcept>

namespace traverse::simulation
{
namespace
{
/** Cells along the edge of the blocks that are asked whether anything sharp lies in them. */
constexpr int kBlock = 8;

/** Columns and rows [from, to) of sub-squares. */
struct SubRect
{
  int from_x = 0, from_y = 0, to_x = 0, to_y = 0;
};

Area around(const SubGrid& grid, const SubRect& rect)
{
  const double margin_m = grid.lattice.cell_m();
  return {
      grid.middleX_m(rect.from_x) - margin_m, grid.middleY_m(rect.from_y) - margin_m,
      grid.middleX_m(rect.to_x) + margin_m, grid.middleY_m(rect.to_y) + margin_m};
}

class Sampler
{
 public:
  Sampler(const Terrain& terrain, const SubGrid& grid) : terrain_(terrain), grid_(grid)
  {
    samples_.height_m.resize(grid.size());
    samples_.base_m.resize(grid.size());
    samples_.ditch_m.resize(grid.size());
    samples_.label.resize(grid.size());
  }

  void exactly(const SubRect& rect)
  {
    for (int row = rect.from_y; row < rect.to_y; ++row)
    {
      for (int column = rect.from_x; column < rect.to_x; ++column)
      {
        put(grid_.at(column, row), terrain_.at(grid_.middleX_m(column), grid_.middleY_m(row)));
      }
    }
  }

  void betweenCells(const SubRect& rect)
  {
    std::array<std::array<GroundAt, kBlock + 2>, kBlock + 2> nodes;
    const int cells_x = (rect.to_x - rect.from_x) / kSubsPerCell;
    const int cells_y = (rect.to_y - rect.from_y) / kSubsPerCell;
    for (int y = 0; y < cells_y + 2; ++y)
    {
      for (int x = 0; x < cells_x + 2; ++x)
      {
        nodes[y][x] = terrain_.at(
            cellMiddle(grid_.minX_m(), rect.from_x / kSubsPerCell + x - 1),
            cellMiddle(grid_.minY_m(), rect.from_y / kSubsPerCell + y - 1));
      }
    }
    for (int row = rect.from_y; row < rect.to_y; ++row)
    {
      for (int column = rect.from_x; column < rect.to_x; ++column)
      {
        put(grid_.at(column, row), between(nodes, column - rect.from_x, row - rect.from_y));
      }
    }
  }

  GroundSamples take() { return std::move(samples_); }

 private:
  double cellMiddle(double from_m, int cell) const
  {
    return from_m + (cell + 0.5) * grid_.lattice.cell_m();
  }

  void put(size_t i, const GroundAt& ground)
  {
    samples_.height_m[i] = static_cast<float>(ground.height_m);
    samples_.base_m[i] = static_cast<float>(ground.base_m);
    samples_.ditch_m[i] = static_cast<float>(ground.ditch_m);
    samples_.label[i] = static_cast<uint8_t>(ground.label);
  }

  /** Of a sub-square counted from the block's corner; nodes begin one cell before it. */
  template <class Nodes>
  static GroundAt between(const Nodes& nodes, int sub_x, int sub_y)
  {
    // middles of sub-squares lie 1/8, 3/8, 5/8, 7/8 of a cell from its edge, nodes 1/2
    const double u = (sub_x + 0.5) / kSubsPerCell + 0.5;
    const double v = (sub_y + 0.5) / kSubsPerCell + 0.5;
    const int x = static_cast<int>(u);
    const int y = static_cast<int>(v);
    const auto mean = [&](double GroundAt::*what)
    {
      const double low = nodes[y][x].*what + (u - x) * (nodes[y][x + 1].*what - nodes[y][x].*what);
      const double high =
          nodes[y + 1][x].*what + (u - x) * (nodes[y + 1][x + 1].*what - nodes[y + 1][x].*what);
      return low + (v - y) * (high - low);
    };
    GroundAt ground = nodes[sub_y / kSubsPerCell + 1][sub_x / kSubsPerCell + 1];
    ground.height_m = mean(&GroundAt::height_m);
    ground.base_m = mean(&GroundAt::base_m);
    ground.ditch_m = mean(&GroundAt::ditch_m);
    return ground;
  }

  const Terrain& terrain_;
  const SubGrid& grid_;
  GroundSamples samples_;
};

/** One run of climbs along a line of sub-squares, from `first` by `step`. */
void climbAlong(
    const std::vector<float>& base_m,
    std::vector<float>& climb_m,
    size_t first,
    int64_t step,
    int count,
    float max_rise_m)
{
  float climbed_m = 0;
  auto here = static_cast<int64_t>(first);
  for (int k = 1; k < count; ++k)
  {
    const auto before = static_cast<size_t>(here);
    here += step;
    const auto now = static_cast<size_t>(here);
    const float rise_m = base_m[now] - base_m[before];
    climbed_m = rise_m > max_rise_m ? climbed_m + rise_m : 0;
    climb_m[now] = std::max(climb_m[now], climbed_m);
  }
}
}  // namespace

SubGrid subGridOf(const Area& area, int32_t cell_mm)
{
  const double cell_m = geometry::Lattice{cell_mm}.cell_m();
  constexpr double kSlack = 1e-9;  // an area that ends on an edge ends there
  const double min_x = std::ceil(area.min_x_m / cell_m - kSlack);
  const double min_y = std::ceil(area.min_y_m / cell_m - kSlack);
  const double max_x = std::floor(area.max_x_m / cell_m + kSlack);
  const double max_y = std::floor(area.max_y_m / cell_m + kSlack);
  if (!(max_x > min_x && max_y > min_y))
  {
    throw std::invalid_argument("the scene's area holds no whole cell");
  }
  if (!((max_x - min_x) * (max_y - min_y) <= static_cast<double>(kMostTruthCells)) ||
      !(std::max({-min_x, -min_y, max_x, max_y}) < 1e9))
  {
    throw std::length_error(
        fmt::format("the scene's area has more than {} cells of {} m", kMostTruthCells, cell_m));
  }
  const auto index = [](double edge) { return static_cast<int32_t>(edge); };
  return {{cell_mm}, {{index(min_x), index(min_y)}, {index(max_x), index(max_y)}}};
}

GroundSamples sampleGround(const Terrain& terrain, const SubGrid& grid)
{
  constexpr int kStep = kBlock * kSubsPerCell;
  Sampler sampler(terrain, grid);
  for (int y = 0; y < grid.height(); y += kStep)
  {
    for (int x = 0; x < grid.width(); x += kStep)
    {
      const SubRect rect = {
          x, y, std::min(x + kStep, grid.width()), std::min(y + kStep, grid.height())};
      const bool at_edge =
          x == 0 || y == 0 || rect.to_x == grid.width() || rect.to_y == grid.height();
      if (at_edge || terrain.isSharpIn(around(grid, rect)))
      {
        sampler.exactly(rect);
      }
      else
      {
        sampler.betweenCells(rect);
      }
    }
  }
  return sampler.take();
}

std::vector<float> climbs(const std::vector<float>& base_m, const SubGrid& grid, float max_rise_m)
{
  std::vector<float> climb_m(grid.size(), 0.0F);
  const int width = grid.width();
  const int height = grid.height();
  for (int row = 0; row < height; ++row)
  {
    climbAlong(base_m, climb_m, grid.at(0, row), 1, width, max_rise_m);
    climbAlong(base_m, climb_m, grid.at(width - 1, row), -1, width, max_rise_m);
  }
  for (int column = 0; column < width; ++column)
  {
    climbAlong(base_m, climb_m, grid.at(column, 0), width, height, max_rise_m);
    climbAlong(base_m, climb_m, grid.at(column, height - 1), -width, height, max_rise_m);
  }
  return climb_m;
}

std::vector<uint8_t> reachable(
    const std::vector<float>& climb_m,
    const SubGrid& grid,
    float max_climb_m,
    const Eigen::Vector2d& start)
{
  std::vector<uint8_t> reached(grid.size(), 0);
  std::vector<std::pair<int, int>> open;
  const auto visit = [&](int column, int row)
  {
    if (column < 0 || row < 0 || column >= grid.width() || row >= grid.height())
    {
      return;
    }
    const size_t i = grid.at(column, row);
    if (reached[i] == 0 && climb_m[i] <= max_climb_m)
    {
      reached[i] = 1;
      open.emplace_back(column, row);
    }
  };
  // the area may end with a part of a cell, which the grid does not have
  const auto sub_at = [&](double from_edge_m, int count)
  { return static_cast<int>(std::clamp(from_edge_m / grid.sub_m(), 0.0, count - 1.0)); };
  const int column = sub_at(start.x() - grid.minX_m(), grid.width());
  const int row = sub_at(start.y() - grid.minY_m(), grid.height());
  // the start itself may stand on a kerb's edge: around it, half a cell
  for (int dy = -kSubsPerCell / 2; dy <= kSubsPerCell / 2; ++dy)
  {
    for (int dx = -kSubsPerCell / 2; dx <= kSubsPerCell / 2; ++dx)
    {
      visit(column + dx, row + dy);
    }
  }
  while (!open.empty())
  {
    const auto [x, y] = open.back();
    open.pop_back();
    visit(x - 1, y);
    visit(x + 1, y);
    visit(x, y - 1);
    visit(x, y + 1);
  }
  return reached;
}
}  // namespace traverse::simulation
