// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "outline.h"

#include <traverse/geometry/exact_trig.h>

#include <algorithm>
#include <cmath>

namespace traverse::navigation
{
Outline::Outline(const geometry::Vehicle& vehicle, const geometry::Pose2& stand)
{
  const geometry::SinCos yaw = geometry::sinCosOfAny(stand.yaw_rad);
  const size_t corners = std::min(vehicle.footprint_xs_m.size(), vehicle.footprint_ys_m.size());
  bool is_finite = corners >= 3;
  for (size_t i = 0; i < corners; ++i)
  {
    const double x = vehicle.footprint_xs_m[i];
    const double y = vehicle.footprint_ys_m[i];
    corners_.push_back(
        {stand.x_m + yaw.cos * x - yaw.sin * y, stand.y_m + yaw.sin * x + yaw.cos * y});
    is_finite = is_finite && std::abs(corners_.back().x_m) < geometry::kFarthest_m &&
                std::abs(corners_.back().y_m) < geometry::kFarthest_m;
  }
  if (!is_finite)
  {
    corners_.clear();
  }
}

bool Outline::contains(double x_m, double y_m) const
{
  // A ray along x to +infinity crosses the outline an odd number of times from inside.
  bool is_inside = false;
  for (size_t i = 0; i < corners_.size(); ++i)
  {
    const Corner& a = corners_[i];
    const Corner& b = corners_[(i + 1) % corners_.size()];
    if ((a.y_m > y_m) == (b.y_m > y_m))
    {
      continue;
    }
    const double crossing_m = a.x_m + (y_m - a.y_m) / (b.y_m - a.y_m) * (b.x_m - a.x_m);
    is_inside = is_inside != (x_m < crossing_m);
  }
  return is_inside;
}

bool Outline::containsAll(const geometry::Lattice& lattice, geometry::CellIndex c) const
{
  const double left = lattice.edge_m(c.x);
  const double right = left + lattice.cell_m();
  const double low = lattice.edge_m(c.y);
  const double high = low + lattice.cell_m();
  return contains(left, low) && contains(right, low) && contains(left, high) &&
         contains(right, high);
}

geometry::CellRect Outline::cellsIn(
    const geometry::Lattice& lattice, const geometry::CellRect& extent) const
{
  geometry::CellRect all;
  for (const Corner& corner : corners_)
  {
    const auto c =
        lattice.cellOf(geometry::toMillimetres(corner.x_m), geometry::toMillimetres(corner.y_m));
    all = geometry::bounding(all, {{c.x, c.y}, {c.x + 1, c.y + 1}});
  }
  return geometry::intersection(all, extent);
}
}  // namespace traverse::navigation
