// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fan_trace.h"

#include <algorithm>
#include <cmath>

// Where the ground falls away. A beam that should have met the ground goes on, and lands lower:
// that is a ditch, a kerb, or a slope that begins there. What tells them apart is the surface it
// lands on and the next beam beyond: carried back straight to where the beam left the ground, a
// slope is at the ground's height there, and a ditch or a kerb is not.
namespace traverse::multi_lidar_grid
{
using layers::OccupancyState;

namespace
{
constexpr float kReference_m = 0.08F;
constexpr float kTilt = 0.005F;

/** The reference must have been measured so near. */
constexpr float kMostGap_m = 2.5F;

/** Nobody looks for the edge of a ditch further back. */
constexpr float kWidest_m = 8;

/** Surfaces are no steeper than one in so many metres for the carrying back. */
constexpr float kLeastStep_m = 0.05F;
}  // namespace

void FanTrace::sink(const BeamFans& fans, std::span<const FanBeam> beams, size_t k)
{
  const FanBeam& beam = beams[k];
  const GroundRay middle = {origin_.x(), origin_.y(), fans.direction(fan_, 0)};
  const GroundRay::Stretch inside = middle.within(side_m_);
  if (beam.slope >= 0 || beam.reach_m > std::min(inside.to_m, scene_.range_m) ||
      beam.reach_m < inside.from_m)
  {
    return;
  }
  const float over_m = heightOver(middle, beam.slope, beam.reach_m);
  if (!(over_m < -(kReference_m + kTilt * beam.reach_m)))
  {
    return;
  }
  const float edge_m = edgeOf(middle, beam);
  if (edge_m <= 0 || dropAt(middle, beams, k, edge_m) < scene_.rules.depth_m())
  {
    return;
  }
  const int32_t rays =
      std::clamp(static_cast<int32_t>(std::ceil(fans.width_rad() * beam.reach_m / cell_m_)), 1, 16);
  for (int32_t i = 0; i < rays; ++i)
  {
    const float part = (static_cast<float>(i) + 0.5F) / static_cast<float>(rays) - 0.5F;
    markNegative({origin_.x(), origin_.y(), fans.direction(fan_, part)}, edge_m, beam.reach_m);
  }
}

/** Where a beam that landed below the ground went through it; -1 where that cannot be told. */
float FanTrace::edgeOf(const GroundRay& ray, const FanBeam& beam) const
{
  const float last_m = std::max(ray.within(side_m_).from_m, beam.reach_m - kWidest_m);
  for (float at_m = beam.reach_m; at_m > last_m; at_m -= cell_m_ / 2)
  {
    const GroundRay::Place place = ray.placeAt(at_m, 1 / cell_m_, edge_);
    const float over_m = origin_.z() + beam.slope * at_m - scene_.ground.heightAt(place.x, place.y);
    if (!(scene_.ground.gapAt(place.x, place.y) <= kMostGap_m))
    {
      return -1;
    }
    if (over_m >= 0)
    {
      return at_m;
    }
  }
  return -1;
}

/** How much lower than the ground the surface beyond the edge begins, m. */
float FanTrace::dropAt(
    const GroundRay& ray, std::span<const FanBeam> beams, size_t k, float edge_m) const
{
  const FanBeam& landed = beams[k];
  const float over_m = heightOver(ray, landed.slope, landed.reach_m);
  const auto beyond = std::find_if(
      beams.begin() + static_cast<std::ptrdiff_t>(k) + 1, beams.end(),
      [&](const FanBeam& b) { return b.is_hit && b.reach_m >= landed.reach_m - kLeastStep_m; });
  if (beyond == beams.end() || beyond->reach_m > ray.within(side_m_).to_m)
  {
    return 0;
  }
  const float next_m = heightOver(ray, beyond->slope, beyond->reach_m);
  if (!(next_m <= scene_.rules.obstacle_m()))  // an obstacle there, or unknown ground
  {
    return -over_m;
  }
  const float step_m = std::max(beyond->reach_m - landed.reach_m, kLeastStep_m);
  const float slope = (std::min(next_m, 0.0F) - over_m) / step_m;
  return slope * (landed.reach_m - edge_m) - over_m;
}

/** Cells without a word of their own, or with returns from below only. */
void FanTrace::markNegative(const GroundRay& ray, float from_m, float to_m)
{
  CellWalk walk(ray, from_m + cell_m_ / 2, cell_m_, edge_);
  do
  {
    if (walk.at_m() > to_m)
    {
      return;
    }
    UnitCell& cell = cellAt(walk.place());
    const bool is_met = scene_.columns.find(walk.place().y * edge_ + walk.place().x) != nullptr;
    const bool is_free = cell.state == OccupancyState::free && !is_met;
    if (is_free || cell.state == OccupancyState::unknown)
    {
      cell.state = OccupancyState::negative;
      cell.free_to = 0;
    }
  } while (walk.next());
}
}  // namespace traverse::multi_lidar_grid
