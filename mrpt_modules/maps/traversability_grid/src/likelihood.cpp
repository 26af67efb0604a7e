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

double logLikelihoodOf(const State& state, const LatticePoint& p, const LikelihoodParams& params)
{
  const Cell* cell = state.cells.get(p.cell);
  const layers::HeightSlab* lowest = cell == nullptr ? nullptr : state.slabs.get(cell->slabs);
  const int64_t z_mm = int64_t{p.level} * state.slab_mm + p.inside.z_mm;
  const double off = distance_mm(state, lowest, z_mm) / geometry::kMillimetresPerMetre;
  const double sigmas = off / params.sigma_m;
  return -std::min(sigmas * sigmas / 2, params.worst);
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
  const auto most = static_cast<size_t>(params.max_points);
  const size_t looked_at = std::min(most, scan.size());
  double sum = 0;
  layers::UpdateStats ignored;
  for (size_t k = 0; k < looked_at; ++k)
  {
    const size_t i = k * scan.size() / looked_at;
    const auto point = projection->project({scan.x[i], scan.y[i], scan.z[i]}, ignored);
    sum -= point ? -logLikelihoodOf(state, *point, params) : params.worst;
  }
  return sum;
}
}  // namespace traverse::traversability_grid
