// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surfaces.h"

#include "flat_support.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace traverse::ground
{
namespace
{
/** Weight of a patch without points beside one with, in the height of the ground. */
constexpr float kGuessed = 0.1F;
constexpr float kLeastWeight = 1e-9F;

/** A column further below the patches is a hole or a false return. */
constexpr float kBelow_m = 0.30F;

/** A surface this much above the patches needs neighbours at its height, within so much, to be
 * ground. */
constexpr float kRaised_m = 0.08F;
constexpr float kSame_m = 0.06F;

/** All points of a flat column are ground. */
constexpr float kOverMean_m = 0.10F;

/** Without a flat column nearby the foot of a rough one counts, so little below the patches. */
constexpr float kFootBelow_m = 0.10F;

float orNone(bool holds, float height_m)
{
  const Verdict none;
  return holds ? height_m : none.limit_m;
}

/** Four patches that meet in a corner: the lower two, then the upper two. */
struct Corner
{
  Quad z_m = {};
  Quad slope_x = {};
  Quad slope_y = {};
  Quad weight = {};  //!< of a patch's share; 0 until it is settled
  Quad least = {};

  Corner(const PatchGrid& grid, int32_t lower_left)
  {
    const std::array<int32_t, 4> patches = {
        lower_left, lower_left + 1, lower_left + grid.stride(), lower_left + grid.stride() + 1};
    for (size_t k = 0; k < patches.size(); ++k)
    {
      const Patch& p = grid.at(patches[k]);
      z_m[k] = p.z_m();
      slope_x[k] = p.slopeX();
      slope_y[k] = p.slopeY();
      least[k] = p.isSettled() ? kLeastWeight : 0;
      const float weight_of = p.measured > 0 ? 1 : kGuessed;
      weight[k] = p.isSettled() ? weight_of : 0;
    }
  }
};

/** A patch's four corners: what the ground's height in its cells is made of. */
class Corners
{
 public:
  Corners(const PatchGrid& grid, int32_t patch) :
      grid_(grid),
      side_m_(grid.side_m()),
      corners_{
          Corner(grid, patch - grid.stride() - 1), Corner(grid, patch - grid.stride()),
          Corner(grid, patch - 1), Corner(grid, patch)}
  {
  }

  struct Ground
  {
    float z_m = std::numeric_limits<float>::quiet_NaN();
    GroundPlane nearest;
  };

  /** From the planes of the four patches around, by distance; NaN where none is settled. And the
   * plane among them that is nearest to the column's mean: beside a kerb that of its own side. */
  Ground groundAt(const PlacedColumn& column) const
  {
    const PatchGrid::Along& x = grid_.along(column.x);
    const PatchGrid::Along& y = grid_.along(column.y);
    const int32_t corner = 3 + 2 * y.lower + x.lower;
    const Corner& c = corners_[static_cast<size_t>(corner)];
    const Quad right = {x.part, x.part - 1, x.part, x.part - 1};
    const Quad up = {y.part, y.part, y.part - 1, y.part - 1};
    const Quad share_x = {1 - x.part, x.part, 1 - x.part, x.part};
    const Quad share_y = {1 - y.part, 1 - y.part, y.part, y.part};
    const Quad w = share_x * share_y * c.weight + c.least;
    const Quad planes = c.z_m + side_m_ * (c.slope_x * right + c.slope_y * up);
    const Quad z = w * planes;
    const float weights = w[0] + w[1] + w[2] + w[3];
    Ground ground;
    if (weights > 0)
    {
      ground.z_m = (z[0] + z[1] + z[2] + z[3]) / weights;
      ground.nearest = nearestTo(column.mean_m, c, planes);
    }
    return ground;
  }

 private:
  GroundPlane nearestTo(float mean_m, const Corner& c, const Quad& planes) const
  {
    constexpr float kUnmeasured_m = 1e6F;
    GroundPlane nearest;
    float least_m = 2 * kUnmeasured_m;
    for (int k = 0; k < 4; ++k)
    {
      const bool is_measured = c.weight[k] == 1;
      const float off_m = std::abs(planes[k] - mean_m) + (is_measured ? 0 : kUnmeasured_m);
      if (c.weight[k] > 0 && off_m < least_m)
      {
        least_m = off_m;
        const float slopes = std::abs(c.slope_x[k]) + std::abs(c.slope_y[k]);
        nearest = {planes[k], slopes * grid_.cell_m() / 2, is_measured};
      }
    }
    return nearest;
  }

  const PatchGrid& grid_;
  float side_m_;
  std::array<Corner, 4> corners_;
};

/** What the patch's slope adds to a cell's span. */
float tiltOf(const Patch& patch, float cell_m)
{
  const auto tilt = [&](float slope) { return std::abs(beyondNoise(slope)) * cell_m; };
  return tilt(patch.slopeX()) + tilt(patch.slopeY());
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
  relief_.reset(columns.size());
  for (const PatchGrid::Block& block : grid.blocks())
  {
    const Corners corners(grid, block.patch);
    const float tilt = tiltOf(grid.at(block.patch), grid.cell_m());
    const float most_span = static_cast<float>(params.flat_m) + tilt;
    for (uint32_t i = block.first; i < block.first + block.size; ++i)
    {
      const PlacedColumn& c = columns[i];
      const Corners::Ground at = corners.groundAt(c);
      const float ground = at.z_m;
      const float over = c.mean_m - ground;
      // & and not &&, because it must not branch.
      bool is_flat = (c.span_m() <= most_span) & (over < over_patch) & (over > -kBelow_m);
      if (is_flat && over >= kRaised_m)
      {
        is_flat = isSupported(grid, block.patch, c, {most_span, kSame_m + tilt});
      }
      const bool may_bear = c.low_m - ground <= over_patch;
      const float limit = c.mean_m + kOverMean_m + tilt;
      const bool bears = is_flat & may_bear & (limit >= c.low_m);
      flat_mean_m_[i] = orNone(is_flat, c.mean_m);
      relief_.measure(grid, block.patch, i, at.nearest, most_span);
      verdicts[c.number] = {ground, orNone(bears, limit), 0, at.nearest.is_measured, false};
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
    verdict.limit_m = orNone(limit >= c.low_m, limit);
  }
  relief_.finish(grid, verdicts);
}
}  // namespace traverse::ground
