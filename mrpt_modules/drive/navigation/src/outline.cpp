// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "outline.h"

#include <traverse/geometry/frame2.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace traverse::navigation
{
Outline::Outline(const geometry::Vehicle& vehicle, const geometry::Pose2& stand) :
    corners_(geometry::Frame2::of(stand).out(geometry::footprintOf(vehicle)))
{
  const auto is_place = [](const Eigen::Vector2d& p)
  { return std::abs(p.x()) < geometry::kFarthest_m && std::abs(p.y()) < geometry::kFarthest_m; };
  if (corners_.size() < 3 || !std::all_of(corners_.begin(), corners_.end(), is_place))
  {
    corners_.clear();
  }
}

bool Outline::containsAll(const geometry::Lattice& lattice, geometry::CellIndex c) const
{
  const double left = lattice.edge_m(c.x);
  const double right = left + lattice.cell_m();
  const double low = lattice.edge_m(c.y);
  const double high = low + lattice.cell_m();
  const std::array<Eigen::Vector2d, 4> ends = {
      {{left, low}, {right, low}, {left, high}, {right, high}}};
  return std::all_of(
      ends.begin(), ends.end(),
      [&](const Eigen::Vector2d& end) { return geometry::contains(corners_, end); });
}

geometry::CellRect Outline::cellsIn(
    const geometry::Lattice& lattice, const geometry::CellRect& extent) const
{
  geometry::CellRect all;
  for (const Eigen::Vector2d& corner : corners_)
  {
    const auto c =
        lattice.cellOf(geometry::toMillimetres(corner.x()), geometry::toMillimetres(corner.y()));
    all = geometry::bounding(all, {{c.x, c.y}, {c.x + 1, c.y + 1}});
  }
  return geometry::intersection(all, extent);
}
}  // namespace traverse::navigation
