// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "polygons.h"

#include <traverse/evaluation/cells.h>
#include <traverse/evaluation/departures.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

namespace traverse::evaluation
{
namespace
{
using Cell = std::pair<int32_t, int32_t>;

/** To keep a cell in a set takes as long as some edges do. */
constexpr uint64_t kWorkOfCell = 10;

/** The cells of the window around a polygon; limits first, so that nothing overflows. */
geometry::CellRect cellsAround(
    const Polygon& polygon, const geometry::Lattice& lattice, const geometry::CellRect& window)
{
  const auto index = [&](double value_m, int32_t least, int32_t most)
  {
    const double cell = std::floor(value_m / lattice.cell_m());
    return static_cast<int32_t>(
        std::clamp(cell, static_cast<double>(least), static_cast<double>(most)));
  };
  const Box box = boxOf(polygon);
  const double margin_m = lattice.cell_m();
  return {
      {index(box.min.x() - margin_m, window.min.x, window.max.x),
       index(box.min.y() - margin_m, window.min.y, window.max.y)},
      {index(box.max.x() + margin_m, window.min.x - 1, window.max.x - 1) + 1,
       index(box.max.y() + margin_m, window.min.y - 1, window.max.y - 1) + 1}};
}

std::set<Cell> coveredBy(
    const MovingFrame& frame,
    const geometry::Lattice& lattice,
    const geometry::CellRect& window,
    Work& work)
{
  const double reach_m = lattice.cell_m() * std::sqrt(0.5);
  std::set<Cell> covered;
  for (const Polygon& polygon : frame.outlines)
  {
    if (!isUsable(polygon))
    {
      continue;
    }
    const geometry::CellRect around = cellsAround(polygon, lattice, window);
    work.spend(
        static_cast<uint64_t>(std::max(around.width(), 0)) *
        static_cast<uint64_t>(std::max(around.height(), 0)) * polygon.size());
    forEachCell(
        around,
        [&](geometry::CellIndex c)
        {
          if (distanceTo(polygon, {lattice.centre_m(c.x), lattice.centre_m(c.y)}) <= reach_m)
          {
            work.spend(kWorkOfCell);
            covered.emplace(c.x, c.y);
          }
        });
  }
  return covered;
}
}  // namespace

std::vector<Departure> departuresOf(
    const std::vector<MovingFrame>& frames,
    const geometry::Lattice& lattice,
    const geometry::CellRect& window)
{
  std::vector<Departure> departures;
  std::map<Cell, size_t> left;  // the last departure from each cell that nothing came to since
  std::set<Cell> before;
  Work work("outlines of moving things that are too large or too many");  // edges, and cells kept
  for (size_t i = 0; i < frames.size(); ++i)
  {
    if (i > 0 && !(frames[i].time_s > frames[i - 1].time_s))
    {
      throw std::invalid_argument("the times of moving things must grow");
    }
    std::set<Cell> now = coveredBy(frames[i], lattice, window, work);
    for (const Cell& cell : now)
    {
      if (const auto gone = left.find(cell); gone != left.end())
      {
        departures[gone->second].again_s = frames[i].time_s;
        left.erase(gone);
      }
    }
    for (const Cell& cell : before)
    {
      if (!now.contains(cell))
      {
        left[cell] = departures.size();
        departures.push_back({{cell.first, cell.second}, frames[i].time_s});
      }
    }
    before = std::move(now);
  }
  return departures;
}
}  // namespace traverse::evaluation
