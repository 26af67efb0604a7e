// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "spread.h"

#include <algorithm>
#include <cmath>

// Which of the surfaces in a patch's columns is its ground.
namespace traverse::ground
{
namespace
{
/** Of a surface's heights within a patch, m: rings and grass, not steps. */
constexpr float kSurfaceSpan_m = 0.10F;

/** A column within this span is one surface with noise; of others the foot is taken. */
constexpr float kOneSurface_m = 0.12F;

/** A surface of fewer points needs the lack of a better one. */
constexpr uint32_t kSupport = 3;
constexpr uint32_t kMostWeight = 4;

/** A kerb's upper side fills most of its patch. */
constexpr float kWide = 0.7F;
constexpr float kKerbFlat_m = 0.06F;

/** A surface may lie so much below what a rise may above: noise. */
constexpr float kBelow_m = 0.05F;

/** A surface so far below what neighbours nearby foretell is a trench where this share of the
 * patch's columns goes on at the foretold height. */
constexpr float kTrench_m = 0.10F;
constexpr float kTrenchGap_m = 2.5F;
constexpr float kTrenchShare = 0.4F;
constexpr float kGoesOn_m = 0.05F;
}  // namespace

void Spread::findCandidates(const Patch& patch, const Prediction& predicted)
{
  const float over_gap = std::max(0.0F, predicted.gap_m - grid_.side_m());
  const float up = std::min(
      static_cast<float>(params_.step_m) + static_cast<float>(params_.slope_change) * over_gap,
      static_cast<float>(params_.most_jump_m));
  const float kerb = std::max(up, static_cast<float>(params_.kerb_m));
  const float rough = std::min(up, static_cast<float>(params_.step_m));
  const float slope_x = beyondNoise(predicted.slopeX());
  const float slope_y = beyondNoise(predicted.slopeY());
  const std::span<const PlacedColumn> columns = grid_.columnsOf(patch);
  candidates_.resize(columns.size());
  size_t high = 0;
  size_t found = 0;
  for (const PlacedColumn& c : columns)  // without a branch: who is none is written over
  {
    const float slope = slope_x * grid_.along(c.x).offset_m + slope_y * grid_.along(c.y).offset_m;
    const float rise = c.low_m - slope - predicted.z_m();
    const float span = c.span_m() - 2 * c.noise_m;
    const float most = span < kKerbFlat_m ? kerb : span < kOneSurface_m ? up : rough;
    const bool is_candidate = (rise >= -up - kBelow_m) & (rise <= most);
    candidates_[found] = {(span < kOneSurface_m ? c.mean_m : c.low_m + kFoot_m) - slope, c.n};
    high += static_cast<size_t>(is_candidate & (rise > up));
    found += static_cast<size_t>(is_candidate);
  }
  candidates_.resize(found);
  if (high > 0 && static_cast<float>(high) < kWide * static_cast<float>(columns.size()))
  {
    std::erase_if(candidates_, [&](const Candidate& c) { return c.z_m - predicted.z_m() > up; });
  }
}

/** The first candidate of the surface to take, where `lowest` is that of the lowest one: beside a
 * ditch or a rut enough columns go on as was predicted. */
size_t Spread::overTrench(size_t lowest, const Prediction& predicted) const
{
  if (candidates_[lowest].z_m > predicted.z_m() - kTrench_m || predicted.gap_m > kTrenchGap_m)
  {
    return lowest;
  }
  const auto goes_on = [&](const Candidate& c)
  { return std::abs(c.z_m - predicted.z_m()) < kGoesOn_m; };
  const auto count = std::count_if(candidates_.begin(), candidates_.end(), goes_on);
  const bool is_trench =
      static_cast<float>(count) >= kTrenchShare * static_cast<float>(candidates_.size());
  const auto first = std::find_if(candidates_.begin(), candidates_.end(), goes_on);
  return is_trench ? static_cast<size_t>(first - candidates_.begin()) : lowest;
}

float Spread::lowestSurface(const Prediction& predicted)
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
  first = overTrench(first, predicted);
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
}  // namespace traverse::ground
