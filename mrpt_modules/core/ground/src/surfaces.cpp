// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surfaces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace traverse::ground
{
namespace
{
/** Weight of a patch without points beside one with, in the height of the ground. */
constexpr float kGuessed = 0.1F;
constexpr float kLeastWeight = 1e-9F;

/** Slopes below this are noise, and add nothing to a cell's span. */
constexpr float kLevel = 0.05F;

/** A column further below the patches is a hole or a false return. */
constexpr float kBelow_m = 0.30F;

/** A surface this much above the patches needs neighbours at its height to be ground: so many of
 * them and such a share of all, within so much. */
constexpr float kRaised_m = 0.08F;
constexpr int kSupport = 2;
constexpr float kSupportShare = 0.3F;
constexpr float kSame_m = 0.06F;

/** All points of a flat column are ground. */
constexpr float kOverMean_m = 0.10F;

/** Without a flat column nearby the foot of a rough one counts, so little below the patches. */
constexpr float kFoot_m = 0.02F;
constexpr float kFootBelow_m = 0.10F;

/** The planes of the patch with a column's cell and of those around it, as its cells see them. */
class Planes
{
 public:
  Planes(const PatchGrid& grid, int32_t patch) : grid_(grid), patch_(patch) {}

  /** Of the four patches around a cell, by distance; NaN where none is settled. */
  float groundAt(const PlacedColumn& column) const
  {
    const PatchGrid::Along& x = grid_.along(column.x);
    const PatchGrid::Along& y = grid_.along(column.y);
    const int32_t above = grid_.stride();
    const int32_t lower = patch_ + y.lower * above + x.lower;
    Sum sum;
    add(sum, lower, x.part, y.part, (1 - x.part) * (1 - y.part));
    add(sum, lower + 1, x.part - 1, y.part, x.part * (1 - y.part));
    add(sum, lower + above, x.part, y.part - 1, (1 - x.part) * y.part);
    add(sum, lower + above + 1, x.part - 1, y.part - 1, x.part * y.part);
    return sum.weights > 0 ? sum.z_m / sum.weights : std::numeric_limits<float>::quiet_NaN();
  }

 private:
  struct Sum
  {
    float weights = 0;
    float z_m = 0;
  };

  void add(Sum& sum, int32_t i, float right, float up, float share) const
  {
    const Patch& p = grid_.at(i);
    const float w = p.isSettled() ? share * (p.measured > 0 ? 1.0F : kGuessed) + kLeastWeight : 0;
    sum.weights += w;
    sum.z_m += w * (p.z_m() + grid_.side_m() * (p.slope_x() * right + p.slope_y() * up));
  }

  const PatchGrid& grid_;
  int32_t patch_;
};

/** What the patch's slope adds to a cell's span. */
float tiltOf(const Patch& patch, float cell_m)
{
  const auto tilt = [&](float slope) { return std::max(0.0F, std::abs(slope) - kLevel) * cell_m; };
  return tilt(patch.slope_x()) + tilt(patch.slope_y());
}

/** Whether enough of the columns around have the height of this one and are as flat. */
bool isSupported(
    const PatchGrid& grid, int32_t patch, const PlacedColumn& column, float most_span_m, float tilt)
{
  int all = -1;  // not the column itself
  int same = -1;
  grid.forEachAround(
      patch, column,
      [&](size_t i)
      {
        const PlacedColumn& other = grid.columns()[i];
        ++all;
        same += static_cast<int>(
            other.span_m() <= most_span_m &&
            std::abs(other.mean_m - column.mean_m) < kSame_m + tilt);
      });
  return same >= kSupport && static_cast<float>(same) >= kSupportShare * static_cast<float>(all);
}

/** A column with more than ground in it: its points are ground up to just above the highest flat
 * column beside it. */
float limitOfRough(
    const PatchGrid& grid,
    const Params& params,
    int32_t patch,
    const PlacedColumn& column,
    float ground_m,
    std::span<const float> flat_mean_m)
{
  float highest = Verdict::kNone;
  float top = Verdict::kNone;
  grid.forEachAround(
      patch, column,
      [&](size_t i)
      {
        top = std::max(top, grid.columns()[i].top_m);
        highest = std::max(highest, flat_mean_m[i]);
      });
  if (highest == Verdict::kNone)
  {
    highest = std::min(ground_m, std::max(column.low_m + kFoot_m, ground_m - kFootBelow_m));
  }
  const bool at_obstacle = top - highest > static_cast<float>(params.obstacle_m);
  return highest + static_cast<float>(at_obstacle ? params.at_obstacle_m : params.over_surface_m);
}
}  // namespace

void Surfaces::judge(const PatchGrid& grid, const Params& params, std::vector<Verdict>& verdicts)
{
  const std::span<const PlacedColumn> columns = grid.columns();
  const auto over_patch = static_cast<float>(params.over_patch_m);
  verdicts.resize(columns.size());
  flat_mean_m_.resize(columns.size());
  rough_.clear();
  for (const PatchGrid::Block& block : grid.blocks())
  {
    const Planes planes(grid, block.patch);
    const float tilt = tiltOf(grid.at(block.patch), grid.cell_m());
    const float most_span = static_cast<float>(params.flat_m) + tilt;
    for (uint32_t i = block.first; i < block.first + block.size; ++i)
    {
      const PlacedColumn& c = columns[i];
      const float ground = planes.groundAt(c);
      const float over = c.mean_m - ground;
      const bool is_flat = c.span_m() <= most_span && over < over_patch && over > -kBelow_m &&
                           (over < kRaised_m || isSupported(grid, block.patch, c, most_span, tilt));
      const bool may_bear = c.low_m - ground <= over_patch;
      const float limit = is_flat && may_bear ? c.mean_m + kOverMean_m + tilt : Verdict::kNone;
      flat_mean_m_[i] = is_flat ? c.mean_m : Verdict::kNone;
      verdicts[c.number] = {ground, limit >= c.low_m ? limit : Verdict::kNone};
      if (may_bear && !is_flat)
      {
        rough_.push_back({block.patch, i});
      }
    }
  }
  for (const Rough& rough : rough_)
  {
    const PlacedColumn& c = columns[rough.column];
    Verdict& verdict = verdicts[c.number];
    const float limit = limitOfRough(grid, params, rough.patch, c, verdict.ground_m, flat_mean_m_);
    verdict.limit_m = limit >= c.low_m ? limit : Verdict::kNone;
  }
}
}  // namespace traverse::ground
