// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surfaces.h"

#include <algorithm>
#include <cmath>

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

template <class F>
void forEachAround(geometry::CellIndex cell, F&& f)
{
  for (int32_t y = cell.y - 1; y <= cell.y + 1; ++y)
  {
    for (int32_t x = cell.x - 1; x <= cell.x + 1; ++x)
    {
      f(x, y);
    }
  }
}
}  // namespace

Surfaces::Surfaces(const PatchGrid& grid, std::span<const Column> columns, const Params& params) :
    grid_(grid), columns_(columns), params_(params)
{
}

void Surfaces::judge(std::vector<Surface>& surfaces, std::vector<Verdict>& verdicts) const
{
  const size_t n = columns_.size();
  surfaces.assign(n, {});
  verdicts.assign(n, {});
  for (size_t i = 0; i < n; ++i)
  {
    verdicts[i].ground_m = groundAt(columns_[i].cell);
    surfaces[i] = firstLook(columns_[i], verdicts[i].ground_m);
  }
  // Support is looked for among all flat columns, so it is written down before any is dropped.
  for (size_t i = 0; i < n; ++i)
  {
    const bool stays = !surfaces[i].flat || surfaces[i].over_m < kRaised_m ||
                       isSupported(columns_[i], surfaces, i);
    verdicts[i].limit_m = stays ? 0 : Verdict::kNone;
  }
  for (size_t i = 0; i < n; ++i)
  {
    surfaces[i].flat = surfaces[i].flat && verdicts[i].bearsGround();
  }
  for (size_t i = 0; i < n; ++i)
  {
    const Column& c = columns_[i];
    const float ground = verdicts[i].ground_m;
    const bool may_bear = c.low_m - ground <= static_cast<float>(params_.over_patch_m);
    const float limit = !may_bear          ? Verdict::kNone
                        : surfaces[i].flat ? c.mean_m + kOverMean_m + surfaces[i].tilt_m
                                           : limitOfRough(c, ground, surfaces);
    verdicts[i].limit_m = limit >= c.low_m ? limit : Verdict::kNone;
  }
}

/** From the planes of the four patches around, by distance. */
float Surfaces::groundAt(geometry::CellIndex cell) const
{
  const PatchGrid::Between at = grid_.between(cell);
  const float side = grid_.side_m();
  float weights = 0;
  float sum = 0;
  const auto add = [&](int32_t offset, float right, float up, float share)
  {
    const Patch& patch = grid_.at(at.patch + offset);
    if (patch.state == Patch::State::settled)
    {
      const float w = share * (patch.measured ? 1.0F : kGuessed) + kLeastWeight;
      weights += w;
      sum += w * (patch.z_m + side * (patch.slope_x * right + patch.slope_y * up));
    }
  };
  const int32_t above = grid_.stride();
  add(0, at.right, at.up, (1 - at.right) * (1 - at.up));
  add(1, at.right - 1, at.up, at.right * (1 - at.up));
  add(above, at.right, at.up - 1, (1 - at.right) * at.up);
  add(above + 1, at.right - 1, at.up - 1, at.right * at.up);
  return weights > 0 ? sum / weights : std::numeric_limits<float>::quiet_NaN();
}

Surface Surfaces::firstLook(const Column& column, float ground_m) const
{
  const Patch& patch = grid_.at(grid_.patchOf(column.cell));
  const auto tilt = [this](float slope)
  { return std::max(0.0F, std::abs(slope) - kLevel) * grid_.cell_m(); };
  Surface s;
  s.over_m = column.mean_m - ground_m;
  s.tilt_m = tilt(patch.slope_x) + tilt(patch.slope_y);
  s.flat = column.top_m - column.low_m <= static_cast<float>(params_.flat_m) + s.tilt_m &&
           s.over_m < static_cast<float>(params_.over_patch_m) && s.over_m > -kBelow_m;
  return s;
}

bool Surfaces::isSupported(const Column& column, std::span<const Surface> surfaces, size_t i) const
{
  int all = -1;  // not the column itself
  int same = -1;
  const float tilt = surfaces[i].tilt_m;
  forEachAround(
      column.cell,
      [&](int32_t x, int32_t y)
      {
        const int32_t k = grid_.columnAt(x, y);
        if (k < 0)
        {
          return;
        }
        const Column& other = columns_[static_cast<size_t>(k)];
        ++all;
        same += static_cast<int>(
            other.top_m - other.low_m <= static_cast<float>(params_.flat_m) + tilt &&
            std::abs(other.mean_m - column.mean_m) < kSame_m + tilt);
      });
  return same >= kSupport && static_cast<float>(same) >= kSupportShare * static_cast<float>(all);
}

/** A column with more than ground in it: its points are ground up to just above the highest flat
 * column beside it. */
float Surfaces::limitOfRough(
    const Column& column, float ground_m, std::span<const Surface> surfaces) const
{
  float highest = Verdict::kNone;
  float top = Verdict::kNone;
  forEachAround(
      column.cell,
      [&](int32_t x, int32_t y)
      {
        const int32_t k = grid_.columnAt(x, y);
        if (k < 0)
        {
          return;
        }
        const Column& other = columns_[static_cast<size_t>(k)];
        top = std::max(top, other.top_m);
        highest = surfaces[static_cast<size_t>(k)].flat ? std::max(highest, other.mean_m) : highest;
      });
  if (highest == Verdict::kNone)
  {
    highest = std::min(ground_m, std::max(column.low_m + kFoot_m, ground_m - kFootBelow_m));
  }
  const bool at_obstacle = top - highest > static_cast<float>(params_.obstacle_m);
  return highest + static_cast<float>(at_obstacle ? params_.at_obstacle_m : params_.over_surface_m);
}
}  // namespace traverse::ground
