// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "spread.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace traverse::ground
{
namespace
{
constexpr size_t kNearest = 8;

/** Of a surface's heights within a patch, m: rings and grass, not steps. */
constexpr float kSurfaceSpan_m = 0.10F;

/** A column within this span is one surface with noise; of others the foot is taken. */
constexpr float kOneSurface_m = 0.12F;
constexpr float kFoot_m = 0.02F;

/** A surface of fewer points needs the lack of a better one. */
constexpr uint32_t kSupport = 3;
constexpr uint32_t kMostWeight = 4;

/** A kerb's upper side fills most of its patch. */
constexpr float kWide = 0.7F;
constexpr float kKerbFlat_m = 0.06F;

/** A surface may lie so much below what a rise may above: noise. */
constexpr float kBelow_m = 0.05F;

/** A slope less what may be noise. */
float beyondNoise(float slope)
{
  constexpr float kLevel = 0.05F;
  return slope - std::clamp(slope, -kLevel, kLevel);
}

/** Where nothing is measured a slope fades by this from patch to patch. */
constexpr float kFade = 0.8F;

/** Weight of the predicted slope beside the measured one, m^2. */
constexpr float kSlopePrior_m2 = 4;
}  // namespace

Spread::Spread(PatchGrid& grid, std::span<const Column> columns, const Params& params) :
    grid_(grid),
    columns_(columns),
    params_(params),
    most_slope_(static_cast<float>(std::tan(params.most_slope_deg * std::numbers::pi / 180))),
    around_()
{
  size_t count = 0;
  for (const int32_t radius : {1, 2})
  {
    for (int32_t y = -radius; y <= radius; ++y)
    {
      for (int32_t x = -radius; x <= radius; ++x)
      {
        if (std::max(std::abs(x), std::abs(y)) == radius)
        {
          const auto square = static_cast<float>(x * x + y * y);
          const float side = grid.side_m();
          around_[count++] = {
              y * grid.stride() + x, static_cast<float>(x) * side, static_cast<float>(y) * side,
              std::sqrt(square) * side, 1 / square};
        }
      }
    }
  }
}

void Spread::from(std::span<const Seed> seeds)
{
  for (const Seed& seed : seeds)
  {
    plant(seed);
  }
  const size_t planted = queue_.size();
  for (size_t i = 0; i < planted; ++i)
  {
    pushAround(queue_[i]);
  }
  for (size_t i = planted; i < queue_.size(); ++i)
  {
    const int32_t patch = queue_[i];
    settle(patch, predict(patch));
    if (grid_.at(patch).gap_m < static_cast<float>(params_.most_gap_m))
    {
      pushAround(patch);
    }
  }
}

void Spread::plant(const Seed& seed)
{
  const PatchGrid::Position middle = grid_.positionOf(seed.x_m, seed.y_m);
  const float side = grid_.side_m();
  const auto reach = static_cast<int32_t>(seed.radius_m / side) + 1;
  const auto column = static_cast<int32_t>(std::lround(middle.x));
  const auto row = static_cast<int32_t>(std::lround(middle.y));
  for (int32_t y = row - reach; y <= row + reach; ++y)
  {
    for (int32_t x = column - reach; x <= column + reach; ++x)
    {
      const float dx = (static_cast<float>(x) - middle.x) * side;
      const float dy = (static_cast<float>(y) - middle.y) * side;
      const float distance = std::sqrt(dx * dx + dy * dy);
      const int32_t i = grid_.patchAt(x, y);
      const bool is_seed = distance <= seed.radius_m || (x == column && y == row);
      if (i < 0 || !is_seed || grid_.at(i).state != Patch::State::unseen)
      {
        continue;
      }
      settle(
          i,
          {seed.z_m + seed.slope_x * dx + seed.slope_y * dy, seed.slope_x, seed.slope_y, distance});
      queue_.push_back(i);
    }
  }
}

void Spread::pushAround(int32_t patch)
{
  for (size_t k = 0; k < kNearest; ++k)
  {
    Patch& next = grid_.at(patch + around_[k].offset);
    if (next.state == Patch::State::unseen)
    {
      next.state = Patch::State::queued;
      queue_.push_back(patch + around_[k].offset);
    }
  }
}

Spread::Prediction Spread::predict(int32_t i) const
{
  // Where there are no points the nearest patches will do.
  const size_t count = grid_.at(i).block < 0 ? kNearest : around_.size();
  float weights = 0;
  Prediction sum;
  sum.gap_m = Patch::kFar;
  for (size_t k = 0; k < count; ++k)  // without a branch: who is not settled has no trust
  {
    const Neighbour& n = around_[k];
    const Patch& p = grid_.at(i + n.offset);
    const float w = n.weight * p.trust;
    weights += w;
    sum.z_m += w * (p.z_m - p.slope_x * n.x_m - p.slope_y * n.y_m);
    sum.slope_x += w * p.slope_x;
    sum.slope_y += w * p.slope_y;
    sum.gap_m = std::min(sum.gap_m, p.gap_m + n.distance_m);
  }
  return {sum.z_m / weights, sum.slope_x / weights, sum.slope_y / weights, sum.gap_m};
}

void Spread::settle(int32_t i, const Prediction& predicted)
{
  Patch& patch = grid_.at(i);
  patch.state = Patch::State::settled;
  patch.z_m = predicted.z_m;
  patch.gap_m = predicted.gap_m;
  patch.slope_x = kFade * predicted.slope_x;
  patch.slope_y = kFade * predicted.slope_y;
  findCandidates(patch, predicted);
  if (!candidates_.empty())
  {
    patch.z_m = lowestSurface();
    patch.gap_m = 0;
    patch.measured = true;
    fitSlope(i, predicted);
  }
  patch.trust = 1 / (1 + patch.gap_m);
}

void Spread::findCandidates(const Patch& patch, const Prediction& predicted)
{
  const float over_gap = std::max(0.0F, predicted.gap_m - grid_.side_m());
  const float up = std::min(
      static_cast<float>(params_.step_m) + static_cast<float>(params_.slope_change) * over_gap,
      static_cast<float>(params_.most_jump_m));
  const float kerb = std::max(up, static_cast<float>(params_.kerb_m));
  size_t high = 0;
  size_t columns = 0;
  candidates_.clear();
  const std::span<const int32_t> numbers = grid_.columnsOf(patch);
  for (size_t k = 0; k < numbers.size(); ++k)
  {
    if (numbers[k] < 0)
    {
      continue;
    }
    ++columns;
    const Column& c = columns_[static_cast<size_t>(numbers[k])];
    const float slope = beyondNoise(predicted.slope_x) * grid_.offset_m(k % grid_.cells()) +
                        beyondNoise(predicted.slope_y) * grid_.offset_m(k / grid_.cells());
    const float rise = c.low_m - slope - predicted.z_m;
    const float span = c.top_m - c.low_m;
    if (rise < -up - kBelow_m ||
        rise > (span < kKerbFlat_m     ? kerb
                : span < kOneSurface_m ? up
                                       : std::min(up, static_cast<float>(params_.step_m))))
    {
      continue;
    }
    high += static_cast<size_t>(rise > up);
    candidates_.push_back({(span < kOneSurface_m ? c.mean_m : c.low_m + kFoot_m) - slope, c.n});
  }
  if (high > 0 && static_cast<float>(high) < kWide * static_cast<float>(columns))
  {
    std::erase_if(candidates_, [&](const Candidate& c) { return c.z_m - predicted.z_m > up; });
  }
}

float Spread::lowestSurface()
{
  std::sort(
      candidates_.begin(), candidates_.end(),
      [](const Candidate& a, const Candidate& b)
      { return a.z_m < b.z_m || (a.z_m == b.z_m && a.n < b.n); });
  const auto surface = [&](size_t first, auto&& use)
  {
    for (size_t k = first;
         k < candidates_.size() && candidates_[k].z_m < candidates_[first].z_m + kSurfaceSpan_m;
         ++k)
    {
      use(candidates_[k]);
    }
  };
  size_t first = 0;
  for (size_t k = 0; k < candidates_.size(); ++k)
  {
    uint32_t n = 0;
    surface(k, [&](const Candidate& c) { n += std::min(c.n, kSupport); });
    if (n >= kSupport)
    {
      first = k;
      break;
    }
  }
  float sum = 0;
  float weights = 0;
  surface(
      first,
      [&](const Candidate& c)
      {
        const auto w = static_cast<float>(std::min(c.n, kMostWeight));
        sum += w * c.z_m;
        weights += w;
      });
  return sum / weights;
}

void Spread::fitSlope(int32_t i, const Prediction& predicted)
{
  Patch& patch = grid_.at(i);
  float xx = kSlopePrior_m2;
  float xy = 0;
  float yy = kSlopePrior_m2;
  float xz = kSlopePrior_m2 * predicted.slope_x;
  float yz = kSlopePrior_m2 * predicted.slope_y;
  for (const Neighbour& n : around_)
  {
    const Patch& p = grid_.at(i + n.offset);
    if (p.state == Patch::State::settled && p.measured)
    {
      const float dz = p.z_m - patch.z_m;
      xx += n.x_m * n.x_m;
      xy += n.x_m * n.y_m;
      yy += n.y_m * n.y_m;
      xz += n.x_m * dz;
      yz += n.y_m * dz;
    }
  }
  const float determinant = xx * yy - xy * xy;
  patch.slope_x = (xz * yy - yz * xy) / determinant;
  patch.slope_y = (yz * xx - xz * xy) / determinant;
  const float steepness = std::sqrt(patch.slope_x * patch.slope_x + patch.slope_y * patch.slope_y);
  if (steepness > most_slope_)
  {
    patch.slope_x *= most_slope_ / steepness;
    patch.slope_y *= most_slope_ / steepness;
  }
}
}  // namespace traverse::ground
