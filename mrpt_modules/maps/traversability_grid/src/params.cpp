// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/geometry/lattice.h>
#include <traverse/traversability_grid/params.h>

#include <algorithm>
#include <cmath>

namespace traverse::traversability_grid
{
namespace
{
/** 10,000 cells along an edge: 100 million cells of layers are already gigabytes. */
constexpr double kMostCellsAlongAnEdge = 10000;

void rises(std::string_view key, double low, double high, std::string_view low_key)
{
  if (high < low)
  {
    throw options::OptionError(
        key, options::format(high),
        "not below " + std::string(low_key) + " = " + options::format(low));
  }
}

void checkEdge(std::string_view key, double edge_m, double cell_size_m)
{
  if (!(edge_m >= cell_size_m) || !(edge_m / cell_size_m <= kMostCellsAlongAnEdge))
  {
    throw options::OptionError(
        key, options::format(edge_m),
        "extents of 1 to 10000 cells of cell_size_m = " + options::format(cell_size_m));
  }
}
}  // namespace

void check(const Params& p)
{
  options::check(p);
  rises(
      "small_max_deviation_m", p.flat.deviation_m, p.small_roughness.deviation_m,
      "flat_max_deviation_m");
  rises(
      "large_max_deviation_m", p.small_roughness.deviation_m, p.large_roughness.deviation_m,
      "small_max_deviation_m");
  rises("small_max_slope_deg", p.flat.slope_deg, p.small_roughness.slope_deg, "flat_max_slope_deg");
  rises(
      "large_max_slope_deg", p.small_roughness.slope_deg, p.large_roughness.slope_deg,
      "small_max_slope_deg");
  rises(
      "small_max_variance_m2", p.flat.variance_m2, p.small_roughness.variance_m2,
      "flat_max_variance_m2");
  rises(
      "large_max_variance_m2", p.small_roughness.variance_m2, p.large_roughness.variance_m2,
      "small_max_variance_m2");
  rises("index_small_roughness", p.index_flat, p.index_small_roughness, "index_flat");
  rises(
      "index_large_roughness", p.index_small_roughness, p.index_large_roughness,
      "index_small_roughness");
  const double cell_mm = p.cell_size_m * geometry::kMillimetresPerMetre;
  if (std::abs(cell_mm - std::round(cell_mm)) > 1e-6)  // far above rounding, far below 1 mm
  {
    throw options::OptionError("cell_size_m", options::format(p.cell_size_m), "whole millimetres");
  }
  checkEdge("window_m", p.window_m, p.cell_size_m);
  constexpr double kMostPatchesAlongTheWindow = 3000;
  if (p.classifier == ClassifierKind::standard &&
      p.window_m / std::max(p.ground.patch_m, p.cell_size_m) > kMostPatchesAlongTheWindow)
  {
    throw options::OptionError(
        "ground_patch_m", options::format(p.ground.patch_m),
        "patches of at least window_m / 3000 = " +
            options::format(p.window_m / kMostPatchesAlongTheWindow));
  }
  if (p.extent == Extent::fixed)
  {
    checkEdge("fixed_max_x_m", p.fixed_max_x_m - p.fixed_min_x_m, p.cell_size_m);
    checkEdge("fixed_max_y_m", p.fixed_max_y_m - p.fixed_min_y_m, p.cell_size_m);
  }
}
}  // namespace traverse::traversability_grid
