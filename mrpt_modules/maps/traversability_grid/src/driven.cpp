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

float meanOf(int64_t sum, uint64_t n, double unit)
{
  return static_cast<float>(static_cast<double>(sum) / static_cast<double>(n) * unit);
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
  Sums& sums = cells_[{cell.y, cell.x}];
  if (sums.n == kMostStands)
  {
    return;
  }
  ++sums.n;
  sums.z_mm += geometry::toMillimetres(p.z());
  sums.slope_x += std::llround(slope_x / kSlopeUnit);
  sums.slope_y += std::llround(slope_y / kSlopeUnit);
}

void DrivenCells::add(const DrivenCells& other)
{
  for (const auto& [place, more] : other.cells_)
  {
    Sums& sums = cells_[place];
    if (more.n > kMostStands - sums.n)
    {
      continue;
    }
    sums.n += more.n;
    sums.z_mm += more.z_mm;
    sums.slope_x += more.slope_x;
    sums.slope_y += more.slope_y;
  }
}

void DrivenCells::keep(const geometry::CellRect& window)
{
  std::erase_if(cells_, [&](const auto& entry) { return !window.contains(cellOf(entry.first)); });
}

int64_t DrivenCells::referenceIn(const geometry::CellRect& window) const
{
  for (const auto& [place, sums] : cells_)
  {
    if (window.contains(cellOf(place)))
    {
      return sums.z_mm / static_cast<int64_t>(sums.n);
    }
  }
  return 0;
}

void DrivenCells::seedsIn(
    const geometry::CellRect& window,
    const geometry::Lattice& lattice,
    int64_t reference_mm,
    std::vector<ground::Seed>& seeds) const
{
  seeds.clear();
  for (const auto& [place, sums] : cells_)
  {
    const geometry::CellIndex cell = cellOf(place);
    if (!window.contains(cell))
    {
      continue;
    }
    const int64_t above_mm = sums.z_mm - reference_mm * static_cast<int64_t>(sums.n);
    seeds.push_back(
        {lattice.centre_m(cell.x), lattice.centre_m(cell.y), meanOf(above_mm, sums.n, 1e-3),
         meanOf(sums.slope_x, sums.n, kSlopeUnit), meanOf(sums.slope_y, sums.n, kSlopeUnit),
         kStand_m});
  }
}
}  // namespace traverse::traversability_grid
