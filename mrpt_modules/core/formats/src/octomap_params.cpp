// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/octomap_params.h>
#include <traverse/geometry/lattice.h>

#include <cmath>

namespace traverse::formats
{
void check(const OctomapParams& params, double cell_size_m)
{
  options::check(params);
  constexpr double kFinest_m = 0.005;
  const double resolution_mm = params.resolution_m * geometry::kMillimetresPerMetre;
  const bool is_whole = std::abs(resolution_mm - std::round(resolution_mm)) < 1e-6;
  const bool is_fine = params.resolution_m <= cell_size_m;
  if (params.resolution_m != 0 && (!is_whole || !is_fine || params.resolution_m < kFinest_m))
  {
    throw options::OptionError(
        "resolution_m", options::format(params.resolution_m),
        "0 (no octree), or whole millimetres from 0.005 to the map's cells of " +
            options::format(cell_size_m));
  }
}
}  // namespace traverse::formats
