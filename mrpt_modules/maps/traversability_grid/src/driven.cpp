// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/traversability_grid/driven.h>

#include <cmath>

namespace traverse::traversability_grid
{
namespace
{
/** The vehicle's own length: so far around it the ground is taken to go on as it stands. */
constexpr float kStand_m = 1.0F;

/** Steeper poses are a vehicle that lies on its side, or none. */
constexpr double kSteepest = 1.0;

geometry::CellIndex cellOf(const std::pair<int32_t, int32_t>& row_column)
{
  return {row_column.second, row_column.first};
}

DrivenCells::Range only(int64_t value)
{
  return {value, value};
}
}  // namespace

void DrivenCells::add(
    const Eigen::Isometry3d& T_map_base,
    const geometry::Vehicle& vehicle,
    const geometry::Lattice& lattice)
{
  const Eigen::Vector3d p = T_map_base * Eigen::Vector3d(0, 0, -vehicle.base_height_m);
  const Eigen::Vector3d up = T_map_base.linear().col(2);
  const double slope_x = -up.x() / up.z();
  const double slope_y = -up.y() / up.z();
  const bool can_stand =
      up.z() > 0 && std::abs(slope_x) <= kSteepest && std::abs(slope_y) <= kSteepest;
  if (!can_stand)
  {
    return;
  }
  const geometry::CellIndex cell =
      lattice.cellOf(geometry::toMillimetres(p.x()), geometry::toMillimetres(p.y()));
  add({cell.y, cell.x},
      {only(geometry::toMillimetres(p.z())), only(std::llround(slope_x / kSlopeUnit)),
       only(std::llround(slope_y / kSlopeUnit))});
}

void DrivenCells::add(const std::pair<int32_t, int32_t>& row_column, const Stand& stand)
{
  Stand& known = cells_[row_column];
  known.z_mm.add(stand.z_mm);
  known.slope_x.add(stand.slope_x);
  known.slope_y.add(stand.slope_y);
}

void DrivenCells::add(const DrivenCells& other)
{
  for (const auto& [place, stand] : other.cells_)
  {
    add(place, stand);
  }
}

void DrivenCells::keep(const geometry::CellRect& window)
{
  std::erase_if(cells_, [&](const auto& entry) { return !window.contains(cellOf(entry.first)); });
}

template <class F>
void DrivenCells::forEachIn(const geometry::CellRect& window, F&& f) const
{
  auto it = cells_.lower_bound({window.min.y, window.min.x});
  while (it != cells_.end() && it->first.first < window.max.y)
  {
    const auto [row, column] = it->first;
    if (column < window.min.x)
    {
      it = cells_.lower_bound({row, window.min.x});
      continue;
    }
    if (column >= window.max.x)
    {
      it = cells_.lower_bound({row + 1, window.min.x});
      continue;
    }
    if (!f(cellOf(it->first), it->second))
    {
      return;
    }
    ++it;
  }
}

geometry::CellRect DrivenCells::boundsIn(const geometry::CellRect& window) const
{
  geometry::CellRect bounds;
  forEachIn(
      window,
      [&](geometry::CellIndex c, const Stand& /*stand*/)
      {
        bounds = bounds.empty()
                     ? geometry::CellRect{c, {c.x + 1, c.y + 1}}
                     : geometry::CellRect{
                           {std::min(bounds.min.x, c.x), std::min(bounds.min.y, c.y)},
                           {std::max(bounds.max.x, c.x + 1), std::max(bounds.max.y, c.y + 1)}};
        return true;
      });
  return bounds;
}

int64_t DrivenCells::referenceIn(const geometry::CellRect& window) const
{
  int64_t reference_mm = 0;
  forEachIn(
      window,
      [&](geometry::CellIndex /*cell*/, const Stand& stand)
      {
        reference_mm = stand.z_mm.low;
        return false;
      });
  return reference_mm;
}

void DrivenCells::seedsIn(
    const geometry::CellRect& window,
    const geometry::Lattice& lattice,
    int64_t reference_mm,
    std::vector<ground::Seed>& seeds) const
{
  const auto slope = [](const Range& range)
  { return static_cast<float>(range.middle() * kSlopeUnit); };
  seeds.clear();
  forEachIn(
      window,
      [&](geometry::CellIndex cell, const Stand& stand)
      {
        const double above_mm = stand.z_mm.middle() - static_cast<double>(reference_mm);
        seeds.push_back(
            {lattice.centre_m(cell.x), lattice.centre_m(cell.y),
             static_cast<float>(above_mm / geometry::kMillimetresPerMetre), slope(stand.slope_x),
             slope(stand.slope_y), kStand_m});
        return true;
      });
}
}  // namespace traverse::traversability_grid
