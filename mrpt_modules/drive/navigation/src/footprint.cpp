// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/geometry/outline.h>
#include <traverse/navigation/footprint.h>

#include <algorithm>
#include <cmath>

namespace traverse::navigation
{
namespace
{
/** An outline's corners, moved by a margin to all four sides: those of its sum with a square. */
geometry::Outline widened(const geometry::Outline& outline, double margin_m)
{
  geometry::Outline corners;
  for (const Eigen::Vector2d& p : outline)
  {
    for (const double dx : {-margin_m, margin_m})
    {
      corners.emplace_back(p.x() + dx, p.y() - margin_m);
      corners.emplace_back(p.x() + dx, p.y() + margin_m);
    }
  }
  return corners;
}
}  // namespace

Footprint::Footprint(const geometry::Vehicle& vehicle, double margin_m)
{
  const geometry::Outline outline = geometry::footprintOf(vehicle);
  const geometry::Outline corners = margin_m > 0 ? widened(outline, margin_m) : outline;
  for (const Eigen::Vector2d& p : corners)
  {
    radius_m_ = std::max(radius_m_, std::sqrt(p.x() * p.x() + p.y() * p.y()));
  }
  const geometry::Outline hull = geometry::convexHull(corners);
  for (const Eigen::Vector2d& p : hull.empty() ? corners : hull)
  {
    corners_.push_back({p.x(), p.y()});
  }
  if (corners_.empty())
  {
    corners_.push_back({});
  }
}

// The part of a convex outline in the band of a row of cells is convex, so the cells of the row
// that it touches are those of one interval: from the least to the most x of its edges in the band.
void Footprint::addEdge(Place a, Place b, int32_t first_row)
{
  if (a.y_m > b.y_m)
  {
    std::swap(a, b);
  }
  const auto from = static_cast<int32_t>(std::floor(a.y_m));
  const auto to = static_cast<int32_t>(std::floor(b.y_m));
  const double slope = b.y_m > a.y_m ? (b.x_m - a.x_m) / (b.y_m - a.y_m) : 0;
  double x = a.x_m;
  for (int32_t row = from; row <= to; ++row)
  {
    const double end = row == to ? b.x_m : a.x_m + (row + 1 - a.y_m) * slope;
    Reach& reach = reach_[static_cast<size_t>(row - first_row)];
    reach.least = std::min({reach.least, x, end});
    reach.most = std::max({reach.most, x, end});
    x = end;
  }
}

std::span<const RowSpan> Footprint::cells(const Stand& stand, const geometry::Lattice& lattice)
{
  const double cells_per_m = geometry::kMillimetresPerMetre / lattice.cell_mm;
  turned_.clear();
  double least_y = std::numeric_limits<double>::infinity();
  double most_y = -least_y;
  for (const Place& p : corners_)
  {
    const double y = stand.place.y_m + p.x_m * stand.yaw.sin + p.y_m * stand.yaw.cos;
    const double x = stand.place.x_m + p.x_m * stand.yaw.cos - p.y_m * stand.yaw.sin;
    turned_.push_back({x * cells_per_m, y * cells_per_m});
    least_y = std::min(least_y, y * cells_per_m);
    most_y = std::max(most_y, y * cells_per_m);
  }
  const auto first_row = static_cast<int32_t>(std::floor(least_y));
  const auto last_row = static_cast<int32_t>(std::floor(most_y));
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  reach_.assign(static_cast<size_t>(last_row - first_row) + 1, {kInfinity, -kInfinity});
  for (size_t k = 0; k < turned_.size(); ++k)
  {
    addEdge(turned_[k], turned_[(k + 1) % turned_.size()], first_row);
  }
  spans_.clear();
  for (int32_t row = first_row; row <= last_row; ++row)
  {
    const Reach& reach = reach_[static_cast<size_t>(row - first_row)];
    spans_.push_back(
        {row, static_cast<int32_t>(std::floor(reach.least)),
         static_cast<int32_t>(std::floor(reach.most))});
  }
  return spans_;
}

void ObstacleCounts::set(const Costmap& costmap, std::span<const RowSpan> spared)
{
  lattice_ = costmap.lattice;
  extent_ = costmap.extent;
  const auto columns = static_cast<size_t>(extent_.width());
  const auto rows = static_cast<size_t>(extent_.height());
  sums_.assign((columns + 1) * (rows + 1), 0);
  for (size_t k = 0; k < costmap.size(); ++k)
  {
    const bool counts = costmap.passage[k] == Passage::obstacle;
    sums_[(k / columns + 1) * (columns + 1) + k % columns + 1] = counts ? 1 : 0;
  }
  for (const RowSpan& span : spared)
  {
    for (int32_t x = span.first; x <= span.last; ++x)
    {
      if (extent_.contains({x, span.y}))
      {
        sums_
            [static_cast<size_t>(span.y - extent_.min.y + 1) * (columns + 1) +
             static_cast<size_t>(x - extent_.min.x + 1)] = 0;
      }
    }
  }
  for (size_t y = 1; y <= rows; ++y)
  {
    int32_t row_sum = 0;
    for (size_t x = 1; x <= columns; ++x)
    {
      const size_t k = y * (columns + 1) + x;
      row_sum += sums_[k];
      sums_[k] = row_sum + sums_[k - columns - 1];
    }
  }
}

bool ObstacleCounts::any(int32_t x_first, int32_t x_last, int32_t y_first, int32_t y_last) const
{
  const int32_t x0 = std::max(x_first - extent_.min.x, 0);
  const int32_t y0 = std::max(y_first - extent_.min.y, 0);
  const int32_t x1 = std::min(x_last + 1 - extent_.min.x, extent_.width());
  const int32_t y1 = std::min(y_last + 1 - extent_.min.y, extent_.height());
  if (x0 >= x1 || y0 >= y1)
  {
    return false;
  }
  const auto at = [this](int32_t x, int32_t y)
  {
    return sums_
        [static_cast<size_t>(y) * (static_cast<size_t>(extent_.width()) + 1) +
         static_cast<size_t>(x)];
  };
  return at(x1, y1) - at(x0, y1) - at(x1, y0) + at(x0, y0) > 0;
}

bool ObstacleCounts::isHit(Footprint& footprint, const Stand& stand) const
{
  const double r = footprint.radius_m();
  const Place& p = stand.place;
  if (!any(
          columnOf(p.x_m - r, lattice_), columnOf(p.x_m + r, lattice_),
          columnOf(p.y_m - r, lattice_), columnOf(p.y_m + r, lattice_)))
  {
    return false;
  }
  for (const RowSpan& span : footprint.cells(stand, lattice_))
  {
    if (any(span.first, span.last, span.y, span.y))
    {
      return true;
    }
  }
  return false;
}
}  // namespace traverse::navigation
