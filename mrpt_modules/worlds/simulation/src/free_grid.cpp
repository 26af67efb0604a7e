// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "free_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>

namespace traverse::simulation
{
namespace
{
constexpr double kHalfDiagonal = 0.70710678;  // of a cell of length 1
constexpr int kFar = std::numeric_limits<int>::max();

/** A neighbour, and how far it is: 5 and 7 are as 1 and the root of 2. */
struct Neighbour
{
  int column, row, way;
};

constexpr std::array<Neighbour, 8> kNeighbours = {
    {{1, 0, 5}, {0, 1, 5}, {-1, 0, 5}, {0, -1, 5}, {1, 1, 7}, {-1, 1, 7}, {-1, -1, 7}, {1, -1, 7}}};
}  // namespace

double Stand::distanceTo(const Eigen::Vector2d& place) const
{
  const Eigen::Vector2d d = place - middle;
  const double along = std::abs(d.x() * axis.x() + d.y() * axis.y());
  const double aside = std::abs(d.y() * axis.x() - d.x() * axis.y());
  const double x = std::max(0.0, along - half_x_m);
  const double y = std::max(0.0, aside - half_y_m);
  return std::max(0.0, std::sqrt(x * x + y * y) - round_m);
}

double Stand::reach_m() const
{
  return std::sqrt(half_x_m * half_x_m + half_y_m * half_y_m) + round_m;
}

Stand discAt(const Eigen::Vector2d& middle, double radius_m)
{
  Stand stand;
  stand.middle = middle;
  stand.round_m = radius_m;
  return stand;
}

Stand lineBetween(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double half_m)
{
  const Eigen::Vector2d way = to - from;
  const double length = std::sqrt(way.dot(way));
  const Eigen::Vector2d axis =
      length > 0 ? Eigen::Vector2d(way / length) : Eigen::Vector2d(Eigen::Vector2d::UnitX());
  return {(from + to) / 2, axis, length / 2, half_m, 0};
}

FreeGrid::FreeGrid(const SceneExtentParams& area, double margin_m) :
    area_(area),
    margin_m_(margin_m),
    columns_(static_cast<int>((area.max_x_m - area.min_x_m) / kCell_m)),
    rows_(static_cast<int>((area.max_y_m - area.min_y_m) / kCell_m)),
    blocked_(static_cast<size_t>(columns_) * static_cast<size_t>(rows_), 0)
{
}

int FreeGrid::columnOf(double x_m) const
{
  return static_cast<int>(std::floor((x_m - area_.min_x_m) / kCell_m));
}

int FreeGrid::rowOf(double y_m) const
{
  return static_cast<int>(std::floor((y_m - area_.min_y_m) / kCell_m));
}

int FreeGrid::cellOf(const Eigen::Vector2d& place) const
{
  const int column = columnOf(place.x());
  const int row = rowOf(place.y());
  const bool inside = column >= 0 && row >= 0 && column < columns_ && row < rows_;
  return inside ? row * columns_ + column : -1;
}

Eigen::Vector2d FreeGrid::middleOf(int cell) const
{
  const int row = cell / columns_;
  const int column = cell % columns_;
  return {area_.min_x_m + (column + 0.5) * kCell_m, area_.min_y_m + (row + 0.5) * kCell_m};
}

void FreeGrid::block(const Stand& stand)
{
  const double margin = margin_m_ + kHalfDiagonal * kCell_m;
  const double reach = stand.reach_m() + margin;
  const int first_column = std::max(0, columnOf(stand.middle.x() - reach));
  const int last_column = std::min(columns_ - 1, columnOf(stand.middle.x() + reach));
  const int first_row = std::max(0, rowOf(stand.middle.y() - reach));
  const int last_row = std::min(rows_ - 1, rowOf(stand.middle.y() + reach));
  for (int row = first_row; row <= last_row; ++row)
  {
    for (int column = first_column; column <= last_column; ++column)
    {
      const int cell = row * columns_ + column;
      if (stand.distanceTo(middleOf(cell)) < margin)
      {
        blocked_[static_cast<size_t>(cell)] = 1;
      }
    }
  }
}

bool FreeGrid::isFree(const Eigen::Vector2d& place) const
{
  const int cell = cellOf(place);
  return cell >= 0 && blocked_[static_cast<size_t>(cell)] == 0;
}

std::vector<int> FreeGrid::waveFrom(int from, int to) const
{
  // Dijkstra (1959)
  using Entry = std::pair<int, int>;  // way, cell
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  std::vector<int> ways(blocked_.size(), kFar);
  ways[static_cast<size_t>(from)] = 0;
  open.emplace(0, from);
  while (!open.empty() && open.top().second != to)
  {
    const auto [way, cell] = open.top();
    open.pop();
    if (way > ways[static_cast<size_t>(cell)])
    {
      continue;
    }
    for (const Neighbour& n : kNeighbours)
    {
      const int column = cell % columns_ + n.column;
      const int row = cell / columns_ + n.row;
      const int next = row * columns_ + column;
      const auto index = static_cast<size_t>(next);
      const bool inside = column >= 0 && row >= 0 && column < columns_ && row < rows_;
      if (inside && blocked_[index] == 0 && way + n.way < ways[index])
      {
        ways[index] = way + n.way;
        open.emplace(ways[index], next);
      }
    }
  }
  return ways;
}

std::vector<Eigen::Vector2d> FreeGrid::way(
    const Eigen::Vector2d& from, const Eigen::Vector2d& to) const
{
  if (!isFree(from) || !isFree(to))
  {
    return {};
  }
  const int begin = cellOf(from);
  int cell = cellOf(to);
  const std::vector<int> ways = waveFrom(begin, cell);
  if (ways[static_cast<size_t>(cell)] == kFar)
  {
    return {};
  }
  std::vector<Eigen::Vector2d> places = {to};
  while (cell != begin)
  {
    const int left = ways[static_cast<size_t>(cell)];
    for (const Neighbour& n : kNeighbours)
    {
      const int column = cell % columns_ + n.column;
      const int row = cell / columns_ + n.row;
      const bool inside = column >= 0 && row >= 0 && column < columns_ && row < rows_;
      const int next = row * columns_ + column;
      if (inside && ways[static_cast<size_t>(next)] == left - n.way)
      {
        cell = next;
        break;
      }
    }
    places.push_back(cell == begin ? from : middleOf(cell));
  }
  std::reverse(places.begin(), places.end());
  return places;
}
}  // namespace traverse::simulation
