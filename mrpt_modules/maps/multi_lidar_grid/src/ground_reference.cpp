// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ground_reference.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace traverse::multi_lidar_grid
{
namespace
{
using geometry::CellIndex;
using geometry::CellRect;
using geometry::floorDiv;

constexpr double kPatch_m = 0.8;
constexpr double kColumn_m = 0.25;

/** A sensor's clouds are looked at for ground when one of these borders was passed. */
constexpr int64_t kEvery_ns = 500'000'000;
constexpr double kEvery_m = 4;

/** So far from measured ground its continuation counts: at 40 m the rings of a lidar on a roof are
 * 12 m apart. */
constexpr float kMostGap_m = 6;

/** A column's points up to here over its lowest are looked at. */
constexpr float kColumnHeight_m = 1.0F;

/** The vehicle is taken to stand on a plane at least so far around its middle. */
constexpr float kStand_m = 1.0F;

ground::Params paramsFor(const geometry::Vehicle& vehicle)
{
  ground::Params params;
  params.patch_m = kPatch_m;
  params.step_m = std::max(params.step_m, vehicle.max_step_m);
  params.most_slope_deg = std::max(params.most_slope_deg, vehicle.max_slope_deg);
  return params;
}

int32_t mergedCells(const geometry::Lattice& lattice)
{
  return std::max(1, static_cast<int32_t>(std::lround(kColumn_m / lattice.cell_m())));
}

int32_t patchesAlong(int32_t edge, int32_t patch_cells)
{
  return edge / patch_cells + 3;
}
}  // namespace

GroundReference::GroundReference(
    const geometry::Lattice& lattice, int32_t edge, const geometry::Vehicle& vehicle) :
    lattice_(lattice),
    coarse_{lattice.cell_mm * mergedCells(lattice)},
    merged_(mergedCells(lattice)),
    patch_cells_(merged_ * ground::cellsAlongPatch(kPatch_m, coarse_)),
    vehicle_(vehicle),
    params_(paramsFor(vehicle)),
    planes_(patchesAlong(edge, patch_cells_)),
    last_()
{
}

CellIndex GroundReference::patchOf(CellIndex cell) const
{
  return {
      static_cast<int32_t>(floorDiv(cell.x, patch_cells_)),
      static_cast<int32_t>(floorDiv(cell.y, patch_cells_))};
}

double GroundReference::middle_m(int32_t patch) const
{
  return (static_cast<double>(patch) + 0.5) * patch_cells_ * lattice_.cell_m();
}

void GroundReference::moveTo(CellIndex centre)
{
  planes_.moveTo(patchOf(centre));
}

bool GroundReference::isDue(const Stand& stand)
{
  const auto place = [](double metres)
  { return static_cast<int32_t>(std::floor(metres / kEvery_m)); };
  const Eigen::Vector3d p = stand.T_map_base.translation();
  const Slot slot = {floorDiv(stand.stamp, kEvery_ns), {place(p.x()), place(p.y())}};
  const auto bit = static_cast<size_t>(std::countr_zero(stand.sensor_bit)) % last_.size();
  const bool is_due = !(last_[bit] == slot);
  last_[bit] = slot;
  return is_due;
}

GroundPlane<double> GroundReference::planeUnder(const Stand& stand) const
{
  const Eigen::Vector3d up = stand.T_map_base.linear().col(2);
  const Eigen::Vector3d foot = stand.T_map_base.translation() - up * vehicle_.base_height_m;
  const double most = std::max(0.1, std::abs(up.z()));
  GroundPlane<double> plane;
  plane.z_m = foot.z() - stand.zero_m;
  plane.slope_x = static_cast<float>(-up.x() / most);
  plane.slope_y = static_cast<float>(-up.y() / most);
  plane.gap_m = 0;
  return plane;
}

void GroundReference::collect(const BeamPoints& points, const CellRect& region)
{
  const CellRect window = coarseWindow(region);
  const int32_t width = window.width();
  slots_.assign(static_cast<size_t>(width) * static_cast<size_t>(window.height()), -1);
  columns_.clear();
  const int32_t edge = region.width();
  const int32_t offset_x = region.min.x - window.min.x * merged_;
  const int32_t offset_y = region.min.y - window.min.y * merged_;
  slot_of_point_.resize(points.size);
  for (size_t i = 0; i < points.size; ++i)
  {
    slot_of_point_[i] = -1;
    if (points.cell[i] < 0)
    {
      continue;
    }
    const int32_t x = (points.cell[i] % edge + offset_x) / merged_;
    const int32_t y = (points.cell[i] / edge + offset_y) / merged_;
    const int32_t at = y * width + x;
    int32_t& slot = slots_[static_cast<size_t>(at)];
    const float z_m = static_cast<float>(points.z_mm[i]) / 1000;
    if (slot < 0)
    {
      slot = static_cast<int32_t>(columns_.size());
      ground::Column column;
      column.cell = {window.min.x + x, window.min.y + y};
      column.low_m = column.top_m = z_m;
      columns_.push_back(column);
    }
    slot_of_point_[i] = slot;
    float& low_m = columns_[static_cast<size_t>(slot)].low_m;
    low_m = std::min(low_m, z_m);
  }
  addUp(points);
}

/** How high the columns reach, and their means. */
void GroundReference::addUp(const BeamPoints& points)
{
  sums_.assign(columns_.size(), 0);
  for (size_t i = 0; i < points.size; ++i)
  {
    if (slot_of_point_[i] < 0)
    {
      continue;
    }
    const auto slot = static_cast<size_t>(slot_of_point_[i]);
    const float z_m = static_cast<float>(points.z_mm[i]) / 1000;
    ground::Column& column = columns_[slot];
    if (z_m <= column.low_m + kColumnHeight_m)
    {
      column.top_m = column.n == 0 ? z_m : std::max(column.top_m, z_m);
      sums_[slot] += z_m;
      ++column.n;
    }
  }
  for (size_t i = 0; i < columns_.size(); ++i)
  {
    columns_[i].highest_m = columns_[i].top_m;
    columns_[i].mean_m = sums_[i] / static_cast<float>(columns_[i].n);
  }
}

CellRect GroundReference::coarseWindow(const CellRect& region) const
{
  const auto column = [&](int32_t cell) { return static_cast<int32_t>(floorDiv(cell, merged_)); };
  return {
      {column(region.min.x), column(region.min.y)},
      {column(region.max.x - 1) + 1, column(region.max.y - 1) + 1}};
}

void GroundReference::add(const BeamPoints& points, const CellRect& region, const Stand& stand)
{
  collect(points, region);
  if (columns_.empty())
  {
    return;
  }
  const GroundPlane<double> under = planeUnder(stand);
  const Eigen::Vector3d p = stand.T_map_base.translation();
  const ground::Seed seed = {p.x(),         p.y(),         static_cast<float>(under.z_m),
                             under.slope_x, under.slope_y, kStand_m};
  estimator_.spread(columns_, {&seed, 1}, coarse_, coarseWindow(region), params_);
  take(region, stand);
}

void GroundReference::take(const CellRect& region, const Stand& stand)
{
  const CellIndex first = patchOf(region.min);
  const CellIndex last = patchOf({region.max.x - 1, region.max.y - 1});
  const int32_t columns_of_patch = patch_cells_ / merged_;
  const CellRect part = {first, {last.x + 1, last.y + 1}};
  planes_.forEachIn(
      part,
      [&](CellIndex patch, GroundPlane<double>& plane)
      {
        CellIndex inside = {patch.x * columns_of_patch, patch.y * columns_of_patch};
        inside.x = std::max(inside.x, static_cast<int32_t>(floorDiv(region.min.x, merged_)));
        inside.y = std::max(inside.y, static_cast<int32_t>(floorDiv(region.min.y, merged_)));
        const ground::PatchPlane found = estimator_.planeAt(inside);
        if (found.isKnown() && found.gap_m <= std::min(kMostGap_m, plane.gap_m))
        {
          plane = {found.z_m + stand.zero_m, found.slope_x, found.slope_y, found.gap_m};
        }
      });
}

const LocalGround& GroundReference::local(const CellRect& region, const Stand& stand, bool is_level)
{
  const CellIndex first = patchOf(region.min);
  const CellIndex last = patchOf({region.max.x - 1, region.max.y - 1});
  const int32_t stride = last.x - first.x + 1;
  const auto alongs = [&](int32_t min, int32_t max, int32_t first_patch, int32_t step,
                          std::vector<LocalGround::Along>& all)
  {
    all.clear();
    for (int32_t cell = min; cell < max; ++cell)
    {
      const auto patch = static_cast<int32_t>(floorDiv(cell, patch_cells_));
      const int32_t planes_before = (patch - first_patch) * step;
      all.push_back(
          {static_cast<uint32_t>(planes_before),
           static_cast<float>(lattice_.centre_m(cell) - middle_m(patch))});
    }
  };
  alongs(region.min.x, region.max.x, first.x, 1, local_.along_x_);
  alongs(region.min.y, region.max.y, first.y, stride, local_.along_y_);
  const GroundPlane<double> under = planeUnder(stand);
  const Eigen::Vector3d p = stand.T_map_base.translation();
  local_.planes_.clear();
  planes_.forEachIn(
      CellRect{first, {last.x + 1, last.y + 1}},
      [&](CellIndex patch, const GroundPlane<double>& plane)
      {
        GroundPlane<float> here = {
            static_cast<float>(plane.z_m - stand.zero_m), plane.slope_x, plane.slope_y,
            plane.gap_m};
        if (is_level && !here.isKnown())
        {
          const double rise = under.slope_x * (middle_m(patch.x) - p.x()) +
                              under.slope_y * (middle_m(patch.y) - p.y());
          here = {static_cast<float>(under.z_m + rise), under.slope_x, under.slope_y, kMostGap_m};
        }
        local_.planes_.push_back(here);
      });
  return local_;
}

double GroundReference::heightAt(CellIndex cell) const
{
  const CellIndex patch = patchOf(cell);
  const GroundPlane<double>* plane = planes_.get(patch);
  if (plane == nullptr)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return plane->z_m + plane->slope_x * (lattice_.centre_m(cell.x) - middle_m(patch.x)) +
         plane->slope_y * (lattice_.centre_m(cell.y) - middle_m(patch.y));
}
}  // namespace traverse::multi_lidar_grid
