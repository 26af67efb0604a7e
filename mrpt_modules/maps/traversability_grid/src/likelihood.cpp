// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "projection.h"

#include <traverse/traversability_grid/traversability_grid.h>

#include <algorithm>
#include <limits>

namespace traverse::traversability_grid
{
namespace
{
/** Millimetres from z to the nearest slab's heights; infinite where there is no slab. */
double distance_mm(const State& state, const layers::HeightSlab* slab, int64_t z_mm)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (; slab != nullptr; slab = state.slabs.get(slab->next))
  {
    const int64_t bottom = int64_t{slab->level} * state.slab_mm;
    const int64_t below = bottom + slab->min_z_mm - z_mm;
    const int64_t above = z_mm - (bottom + slab->max_z_mm);
    nearest = std::min(nearest, static_cast<double>(std::max({below, above, int64_t{0}})));
  }
  return nearest;
}

double logLikelihoodOf(
    const State& state, geometry::CellIndex index, int64_t z_mm, const LikelihoodParams& params)
{
  const Cell* cell = state.cells.get(index);
  const layers::HeightSlab* lowest = cell == nullptr ? nullptr : state.slabs.get(cell->slabs);
  const double off = distance_mm(state, lowest, z_mm) / geometry::kMillimetresPerMetre;
  const double sigmas = off / params.sigma_m;
  return -std::min(sigmas * sigmas / 2, params.worst);
}

/** `size` points of the scan, evenly picked. */
points::ScanBuffer pick(const points::Scan& scan, size_t size)
{
  points::ScanBuffer picked;
  picked.reserve(size);
  for (size_t k = 0; k < size; ++k)
  {
    const size_t i = k * scan.size() / size;
    picked.x.push_back(scan.x[i]);
    picked.y.push_back(scan.y[i]);
    picked.z.push_back(scan.z[i]);
  }
  return picked;
}
}  // namespace

double logLikelihood(
    const State& state,
    const points::Scan& scan,
    const Eigen::Isometry3d& T_map_base,
    const LikelihoodParams& params)
{
  Params everywhere;
  everywhere.extent = Extent::growing;
  everywhere.window_m = 2000;
  const auto projection = Projection::at(T_map_base, state, everywhere);
  if (state.empty() || !projection || scan.size() == 0)
  {
    return 0;
  }
  const points::ScanBuffer picked =
      pick(scan, std::min(static_cast<size_t>(params.max_points), scan.size()));
  double sum = 0;
  layers::UpdateStats ignored;
  LatticePoints points;
  for (size_t first = 0; first < picked.size(); first += points.size)
  {
    projection->project(picked.view(), first, points, ignored);
    for (size_t i = 0; i < points.size; ++i)
    {
      const geometry::CellIndex min = projection->accepted().min;
      const geometry::CellIndex cell{min.x + points.column[i], min.y + points.row[i]};
      const int64_t z_mm = int64_t{points.level[i]} * state.slab_mm + points.z_mm[i];
      sum += points.column[i] < 0 ? -params.worst : logLikelihoodOf(state, cell, z_mm, params);
    }
  }
  return sum;
}
}  // namespace traverse::traversability_grid
