// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "relief.h"

#include "flat_support.h"

#include <algorithm>
#include <array>

namespace traverse::ground
{
namespace
{
/** The highest place of a surface is so much higher than its highest point where many points are
 * off the ground (beams seldom meet the very top), and the lowest so much lower. */
constexpr float kAboveTop = 1.1F;
constexpr float kBelowBottom = 1.2F;

/** Of m heights spread evenly up to a top, the highest is the top's m/(m+1) on average: half of
 * that share is given back, as points are spread less evenly. */
constexpr float kUnseenShare = 0.5F;

/** A flat surface of fewer points that has others of its height around it may be a pavement of
 * which little was seen: it says nothing. */
constexpr uint32_t kFewPoints = 6;
constexpr float kRaised_m = 0.02F;
constexpr float kSameShare = 0.3F;  // of the relief

/** What so few points do not show of a cell is taken to be like the cells around, the less the more
 * points there are. */
constexpr float kManyPoints = 500;
constexpr size_t kLeastAround = 4;
constexpr float kMajority = 0.6F;

/** What rises higher is a thing of its own: the cells around are not taken to be like it. */
constexpr float kTall_m = 0.25F;

/** Low growth (grass): most points near the ground, which is seen, amid others that are so. */
constexpr float kMostlyLow = 0.25F;
constexpr float kRatherLow = 0.35F;
constexpr float kGroundSeen_m = 0.10F;
constexpr float kLeastGrowth_m = 0.04F;
constexpr float kMostGrowth_m = 0.60F;
constexpr int kGrowthAround = 4;

/** Growth has about one height: from here on the upper quarter around tells it. */
constexpr float kEvenGrowth_m = 0.07F;
constexpr float kUpperQuarter = 0.75F;

size_t rankOf(float share, size_t count)
{
  return std::min(count - 1, static_cast<size_t>(share * static_cast<float>(count)));
}

float risen(const PlacedColumn& column, float mean_m, float up_m)
{
  const auto n = static_cast<float>(column.n);
  const float off_ground = std::clamp(2 * n * mean_m / up_m, 1.0F, n);
  return kAboveTop * up_m * (1 + kUnseenShare / off_ground);
}
}  // namespace

bool Relief::Shape::isMostlyLow(float share) const
{
  return top_m > kLeastGrowth_m && top_m < kMostGrowth_m && low_m < kGroundSeen_m &&
         mean_m < share * top_m;
}

void Relief::reset(size_t columns)
{
  shapes_.resize(columns);
  raised_.clear();
}

void Relief::measure(
    const PatchGrid& grid,
    int32_t patch,
    uint32_t column_at,
    const GroundPlane& plane,
    float most_span_m)
{
  const PlacedColumn& column = grid.columns()[column_at];
  Shape& shape = shapes_[column_at];
  shape.low_m = column.low_m - plane.z_m;
  shape.mean_m = column.mean_m - plane.z_m;
  shape.top_m = column.highest_m - plane.z_m;
  const float up_m = shape.top_m - plane.tilt_m - column.noise_m;
  const float down_m = -shape.low_m - plane.tilt_m - column.noise_m;
  shape.relief_m = 0;
  if (plane.is_measured)
  {
    const float rise_m = up_m > 0 ? risen(column, shape.mean_m, up_m) : 0;
    shape.relief_m = std::max({0.0F, rise_m, kBelowBottom * down_m});
  }
  const bool is_flat = column.span_m() <= most_span_m;
  if (is_flat && column.n < kFewPoints && shape.mean_m > 0 && shape.relief_m > kRaised_m)
  {
    raised_.push_back({patch, column_at, most_span_m, 2 * plane.tilt_m});
  }
}

void Relief::finish(const PatchGrid& grid, std::vector<Verdict>& verdicts)
{
  for (const Raised& raised : raised_)
  {
    float& relief_m = shapes_[raised.column].relief_m;
    const float same_m = std::max(kRaised_m, kSameShare * relief_m) + raised.tilt_m;
    const PlacedColumn& column = grid.columns()[raised.column];
    if (isSupported(grid, raised.patch, column, {raised.most_span_m, same_m}))
    {
      relief_m = 0;
    }
  }
  for (const PatchGrid::Block& block : grid.blocks())
  {
    for (uint32_t i = block.first; i < block.first + block.size; ++i)
    {
      amongOthers(grid, block.patch, i, verdicts[grid.columns()[i].number]);
    }
  }
}

void Relief::amongOthers(const PatchGrid& grid, int32_t patch, size_t i, Verdict& verdict) const
{
  const Shape& own = shapes_[i];
  const PlacedColumn& column = grid.columns()[i];
  const auto n = static_cast<float>(column.n);
  const bool is_low = own.isMostlyLow(kMostlyLow);
  verdict.relief_m = own.relief_m;
  if (n >= kManyPoints && !is_low)
  {
    return;
  }
  std::array<float, 9> around{};
  size_t count = 0;
  int alike = 0;
  bool is_beside_tall = false;
  grid.forEachAround(
      patch, column,
      [&](size_t k)
      {
        const bool is_growth = shapes_[k].isMostlyLow(kRatherLow);
        is_beside_tall = is_beside_tall || shapes_[k].top_m >= kMostGrowth_m;
        if (k != i && (is_growth || shapes_[k].relief_m < kTall_m))
        {
          around[count++] = shapes_[k].relief_m;
          alike += static_cast<int>(is_growth);
        }
      });
  verdict.is_low_growth = is_low && alike >= kGrowthAround && !is_beside_tall;
  if (count < kLeastAround)
  {
    return;
  }
  const auto end = around.begin() + static_cast<std::ptrdiff_t>(count);
  std::sort(around.begin(), end);
  const float most = around[rankOf(kMajority, count)];
  const bool is_even = verdict.is_low_growth && most > kEvenGrowth_m;
  const float other = is_even ? around[rankOf(kUpperQuarter, count)] : most;
  const float unseen = is_even ? 1 : std::max(0.0F, 1 - n / kManyPoints);
  verdict.relief_m = std::max(own.relief_m, own.relief_m + unseen * (other - own.relief_m));
}
}  // namespace traverse::ground
