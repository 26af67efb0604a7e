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

constexpr geometry::Lattice kStands{DrivenCells::kStand_mm};

/** The stands whose middles lie in a window of cells. */
geometry::CellRect standsOf(const geometry::CellRect& window, const geometry::Lattice& lattice)
{
  const auto first = [&](int32_t cell)
  {
    const int64_t edge_mm = int64_t{cell} * lattice.cell_mm;
    constexpr int64_t kHalf = DrivenCells::kStand_mm / 2;
    return static_cast<int32_t>(-geometry::floorDiv(kHalf - edge_mm, DrivenCells::kStand_mm));
  };
  return {{first(window.min.x), first(window.min.y)}, {first(window.max.x), first(window.max.y)}};
}

int64_t middle_mm(int32_t stand)
{
  return int64_t{stand} * DrivenCells::kStand_mm + DrivenCells::kStand_mm / 2;
}

DrivenCells::Range only(int64_t value)
{
  return {value, value};
}
}  // namespace

void DrivenCells::add(const Eigen::Isometry3d& T_map_base, const geometry::Vehicle& vehicle)
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
      kStands.cellOf(geometry::toMillimetres(p.x()), geometry::toMillimetres(p.y()));
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

void DrivenCells::keep(const geometry::CellRect& window, const geometry::Lattice& lattice)
{
  const geometry::CellRect kept = standsOf(window, lattice);
  std::erase_if(
      cells_,
      [&](const auto& entry) {
        return !kept.contains({entry.first.second, entry.first.first});
      });
}

template <class F>
void DrivenCells::forEachIn(
    const geometry::CellRect& window, const geometry::Lattice& lattice, F&& f) const
{
  const geometry::CellRect stands = standsOf(window, lattice);
  auto it = cells_.lower_bound({stands.min.y, stands.min.x});
  while (it != cells_.end() && it->first.first < stands.max.y)
  {
    const auto [row, column] = it->first;
    if (column < stands.min.x)
    {
      it = cells_.lower_bound({row, stands.min.x});
      continue;
    }
    if (column >= stands.max.x)
    {
      it = cells_.lower_bound({row + 1, stands.min.x});
      continue;
    }
    if (!f(middle_mm(column), middle_mm(row), it->second))
    {
      return;
    }
    ++it;
  }
}

bool DrivenCells::anyIn(const geometry::CellRect& window, const geometry::Lattice& lattice) const
{
  bool any = false;
  forEachIn(
      window, lattice,
      [&](int64_t /*x_mm*/, int64_t /*y_mm*/, const Stand& /*stand*/)
      {
        any = true;
        return false;
      });
  return any;
}

geometry::CellRect DrivenCells::boundsIn(
    const geometry::CellRect& window, const geometry::Lattice& lattice) const
{
  geometry::CellRect bounds;
  forEachIn(
      window, lattice,
      [&](int64_t x_mm, int64_t y_mm, const Stand& /*stand*/)
      {
        const geometry::CellIndex c = lattice.cellOf(x_mm, y_mm);
        bounds = geometry::bounding(bounds, {c, {c.x + 1, c.y + 1}});
        return true;
      });
  return bounds;
}

int64_t DrivenCells::referenceIn(
    const geometry::CellRect& window, const geometry::Lattice& lattice) const
{
  int64_t reference_mm = 0;
  forEachIn(
      window, lattice,
      [&](int64_t /*x_mm*/, int64_t /*y_mm*/, const Stand& stand)
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
  constexpr double kMmPerM = geometry::kMillimetresPerMetre;
  const auto slope = [](const Range& range)
  { return static_cast<float>(range.middle() * kSlopeUnit); };
  seeds.clear();
  forEachIn(
      window, lattice,
      [&](int64_t x_mm, int64_t y_mm, const Stand& stand)
      {
        const auto above_mm = static_cast<double>(stand.z_mm.low - reference_mm);
        seeds.push_back(
            {static_cast<double>(x_mm) / kMmPerM, static_cast<double>(y_mm) / kMmPerM,
             static_cast<float>(above_mm / kMmPerM), slope(stand.slope_x), slope(stand.slope_y),
             kStand_m});
        return true;
      });
}
}  // namespace traverse::traversability_grid
