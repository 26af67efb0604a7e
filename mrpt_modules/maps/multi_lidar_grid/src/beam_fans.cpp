// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "beam_fans.h"

#include <traverse/geometry/exact_trig.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace traverse::multi_lidar_grid
{
namespace
{
constexpr int32_t kMostFans = 4096;
constexpr int32_t kLeastFans = 360;

/** Without rings: fans of 0.3 degrees. */
constexpr int32_t kUsualFans = 1200;

/** Fans are so many times as wide as a step between beams: then next to none is without. */
constexpr double kStepsPerFan = 1.25;

/** More rings than that are no rings. */
constexpr int32_t kMostRings = 256;

/** Without rings the elevations are divided into so many rows. */
constexpr int32_t kLevels = 128;
constexpr float kLeastSpread = 0.01F;

/** Enough steps to know the usual one. */
constexpr size_t kSteps = 512;

float sineOf(float slope)
{
  return slope / std::sqrt(1 + slope * slope);
}
}  // namespace

/** The middle one of the steps in azimuth between the beams of the fullest ring, in turns. */
double BeamFans::usualStep(const points::Scan& scan, const BeamPoints& points)
{
  const auto fullest = std::max_element(ring_counts_.begin(), ring_counts_.end());
  const auto ring = static_cast<uint16_t>(fullest - ring_counts_.begin());
  steps_.clear();
  float last = -1;
  for (size_t i = 0; i < points.size && steps_.size() < kSteps; ++i)
  {
    if (scan.ring[i] != ring || points.reach_m[i] < 0)
    {
      continue;
    }
    const float step = std::abs(points.turn[i] - last);
    if (last >= 0 && step > 0)
    {
      steps_.push_back(std::min(step, 1 - step));
    }
    last = points.turn[i];
  }
  if (steps_.empty())
  {
    return 0;
  }
  const auto middle = steps_.begin() + static_cast<std::ptrdiff_t>(steps_.size() / 2);
  std::nth_element(steps_.begin(), middle, steps_.end());
  return *middle;
}

void BeamFans::findLevels(const BeamPoints& points)
{
  float low = 1;
  float high = -1;
  for (size_t i = 0; i < points.size; ++i)
  {
    if (points.reach_m[i] >= 0)
    {
      const float sine = sineOf(points.slope[i]);
      low = std::min(low, sine);
      high = std::max(high, sine);
    }
  }
  const float spread = std::max(high - low, 0.0F);
  rows_ = spread < kLeastSpread ? 1 : kLevels;
  lowest_ = low;
  rows_per_sine_ = static_cast<float>(rows_) / std::max(spread, kLeastSpread);
}

void BeamFans::setFans(int32_t fans)
{
  times_.assign(static_cast<size_t>(fans), 0);
  if (fans == fans_)
  {
    return;
  }
  fans_ = fans;
  width_rad_ = static_cast<float>(2 * geometry::kPi / fans);
  middles_.resize(static_cast<size_t>(fans));
  for (int32_t i = 0; i < fans; ++i)
  {
    const geometry::SinCos v = geometry::sinCosOf((i + 0.5) * 2 * geometry::kPi / fans);
    middles_[static_cast<size_t>(i)] = {static_cast<float>(v.cos), static_cast<float>(v.sin)};
  }
}

void BeamFans::layOut(const points::Scan& scan, const BeamPoints& points)
{
  has_rings_ = scan.ring.size() == points.size && points.size > 0;
  ring_counts_.assign(kMostRings, 0);
  int32_t rings = 0;
  for (size_t i = 0; has_rings_ && i < points.size; ++i)
  {
    rings = std::max<int32_t>(rings, scan.ring[i] + 1);
    has_rings_ = rings <= kMostRings;
    ++ring_counts_[scan.ring[i] % kMostRings];
  }
  if (!has_rings_)
  {
    findLevels(points);
    setFans(kUsualFans);
    return;
  }
  rows_ = rings;
  const double step = usualStep(scan, points) * kStepsPerFan;
  setFans(
      step > 0 ? std::clamp(static_cast<int32_t>(1 / step), kLeastFans, kMostFans) : kUsualFans);
}

size_t BeamFans::levelOf(float slope) const
{
  const float level = (sineOf(slope) - lowest_) * rows_per_sine_;
  return std::min(static_cast<size_t>(std::max(level, 0.0F)), static_cast<size_t>(rows_) - 1);
}

size_t BeamFans::fanOf(float turn) const
{
  return std::min(
      static_cast<size_t>(turn * static_cast<float>(fans_)), static_cast<size_t>(fans_) - 1);
}

void BeamFans::collect(const points::Scan& scan, const BeamPoints& points)
{
  layOut(scan, points);
  const auto rows = static_cast<size_t>(rows_);
  table_.resize(static_cast<size_t>(fans_) * rows);
  has_beam_.assign(static_cast<size_t>(fans_), {});
  steepest_ = 0;
  const bool has_times = scan.time_s.size() == points.size;
  for (size_t i = 0; i < points.size; ++i)
  {
    if (points.reach_m[i] < 0)
    {
      continue;
    }
    const size_t fan = fanOf(points.turn[i]);
    const size_t row = has_rings_ ? scan.ring[i] : levelOf(points.slope[i]);
    FanBeam& beam = table_[fan * rows + row];
    if (!has(has_beam_[fan], row) || points.reach_m[i] < beam.reach_m)
    {
      beam = {points.reach_m[i], points.slope[i], true};
    }
    has_beam_[fan][row / 64] |= uint64_t{1} << (row % 64);
    steepest_ = std::max(steepest_, std::abs(points.slope[i]));
    times_[fan] = has_times ? scan.time_s[i] : 0;
  }
}

void BeamFans::addEmpty(const Empty& empty)
{
  const auto rows = static_cast<size_t>(rows_);
  const size_t fan = fanOf(empty.turn);
  const size_t row = has_rings_ ? empty.row : levelOf(empty.beam.slope);
  if (row < rows && empty.beam.reach_m > 0 && !has(has_beam_[fan], row))
  {
    table_[fan * rows + row] = empty.beam;
    has_beam_[fan][row / 64] |= uint64_t{1} << (row % 64);
    times_[fan] = empty.time_s;
  }
}

namespace
{
/** Among those before `end`, which are sorted. Rows come so unless the sensor is tilted: then a few
 * steps. */
void insert(const FanBeam* first, FanBeam* end, FanBeam beam)
{
  for (; end != first && beam.slope < end[-1].slope; --end)
  {
    *end = end[-1];
  }
  *end = beam;
}
}  // namespace

void BeamFans::sort()
{
  counts_.assign(static_cast<size_t>(fans_), 0);
  for (size_t fan = 0; fan < counts_.size(); ++fan)
  {
    FanBeam* const first = table_.data() + fan * static_cast<size_t>(rows_);
    FanBeam* end = first;
    for (size_t word = 0; word < has_beam_[fan].size(); ++word)
    {
      for (uint64_t rows = has_beam_[fan][word]; rows != 0; rows &= rows - 1)
      {
        const size_t row = word * 64 + static_cast<size_t>(std::countr_zero(rows));
        insert(first, end++, first[row]);
      }
    }
    counts_[fan] = static_cast<uint16_t>(end - first);
  }
}
}  // namespace traverse::multi_lidar_grid
