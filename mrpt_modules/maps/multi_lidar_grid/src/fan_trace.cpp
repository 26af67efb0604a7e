// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fan_trace.h"

#include <algorithm>
#include <cmath>

namespace traverse::multi_lidar_grid
{
using layers::OccupancyState;

namespace
{
/** A beam so far below the ground reference is below the ground, and so much more per metre. */
constexpr float kSunk_m = 0.08F;
constexpr float kSunkPer_m = 0.005F;

int32_t roundedUp(float x)
{
  const auto whole = static_cast<int32_t>(x);
  return static_cast<float>(whole) < x ? whole + 1 : whole;
}

/** Of a cell that a beam passes; without a branch, as nobody guesses its state. */
void setFree(UnitCell& cell, int32_t up_to)
{
  static_assert(static_cast<int>(OccupancyState::unknown) == 0);
  const auto state = static_cast<uint32_t>(cell.state);
  const uint32_t freed = static_cast<uint32_t>(
      cell.hit_from == kHangs ? OccupancyState::overhang : OccupancyState::free);
  const auto if_unknown = static_cast<uint32_t>(state == 0);
  const bool blocks =
      (cell.state == OccupancyState::obstacle) | (cell.state == OccupancyState::negative);
  cell.state = static_cast<OccupancyState>(state + if_unknown * freed);
  cell.up_to =
      static_cast<uint8_t>(std::max<int32_t>(cell.up_to, up_to * static_cast<int32_t>(!blocks)));
}
}  // namespace

FanTrace::FanTrace(const FanScene& scene, UnitMap& map) :
    scene_(scene),
    cells_(map.cells.view()),
    ground_(scene.ground.view()),
    cell_m_(scene.rules.cell_m()),
    edge_(scene.region.width()),
    low_(
        scene.is_level ? Low{scene.rules.robot_m(), 0, 0}
                       : Low{scene.rules.obstacle_m(), kSunk_m, kSunkPer_m})
{
}

void FanTrace::trace(
    const Eigen::Vector3f& origin,
    const BeamFans& fans,
    int32_t fan,
    std::span<const FanBeam> beams)
{
  origin_ = origin;
  fan_ = fan;
  count_ = 0;
  const float needed_m = neededFrom(fans);
  float reached_m = 0;
  for (size_t k = 0; k < beams.size(); ++k)
  {
    const float to_m = std::min(beams[k].reach_m, scene_.range_m);
    if (to_m > reached_m)
    {
      if (to_m > needed_m)
      {
        follow(fans, {reached_m, to_m, beams[k].slope, topSlope(beams, k, to_m)});
      }
      reached_m = to_m;
    }
  }
  const bool seeks_ditches = scene_.rules.depth_mm > 0 && !scene_.is_level;
  if (seeks_ditches && fan % kFansPerDitch == 0)
  {
    findDitches(fans, beams);
  }
}

/** Near the sensor fans are much narrower than cells: every second will do, or every fourth, ...
 * From here on this fan is needed. */
float FanTrace::neededFrom(const BeamFans& fans) const
{
  constexpr int32_t kMost = 64;
  constexpr float kCovered = 0.7F;  // of a cell, by one step between fans
  const int32_t every = fan_ == 0 ? kMost : std::min(fan_ & -fan_, kMost);
  const float step_rad = 2 * static_cast<float>(every) * fans.width_rad();
  return every == kMost ? 0 : kCovered * cell_m_ / step_rad;
}

/** The highest beam up to which none is further over the next lower one than the obstacle height,
 * as far out as the lowest of them goes. */
float FanTrace::topSlope(std::span<const FanBeam> beams, size_t k, float to_m) const
{
  const float most = scene_.rules.obstacle_m() / to_m;
  float top = beams[k].slope;
  for (size_t j = k + 1; j < beams.size() && beams[j].slope - top <= most; ++j)
  {
    top = beams[j].reach_m >= to_m ? beams[j].slope : top;
  }
  return top;
}

void FanTrace::follow(const BeamFans& fans, const Pass& pass)
{
  const int32_t count = roundedUp(fans.width_rad() * pass.to_m / cell_m_);
  spreadWays(fans, static_cast<size_t>(std::clamp<int32_t>(count, 1, kMostWays)));
  for (size_t i = 0; i < count_; ++i)
  {
    const GroundWay& way = ways_[i];
    Pass part = pass;
    part.to_m = std::min(pass.to_m, way.inside.to_m);
    part.from_m = std::max({pass.from_m, way.inside.from_m, lowFrom(way, part)});
    if (part.from_m < part.to_m)
    {
      freeAlong(way, part);
    }
  }
}

/** So many ways side by side across the fan; mostly those of the pass before. */
void FanTrace::spreadWays(const BeamFans& fans, size_t count)
{
  if (count == count_)
  {
    return;
  }
  count_ = count;
  for (size_t i = 0; i < count; ++i)
  {
    const float part = (static_cast<float>(i) + 0.5F) / static_cast<float>(count) - 0.5F;
    ways_[i] = wayTo(fans.direction(fan_, part));
  }
}

/** A beam comes down to its end: it is low only from here on. */
float FanTrace::lowFrom(const GroundWay& way, const Pass& pass) const
{
  constexpr float kMargin = 1.5F;  // the ground's slope is that at the end
  constexpr float kLeastFall = 0.005F;
  if (scene_.is_level || pass.to_m <= 0)
  {
    return 0;
  }
  const GroundRay::Place end = way.placeAt(pass.to_m);
  const float end_m = origin_.z() + pass.slope * pass.to_m;
  const float over_m = end_m - ground_.heightAt(end.x, end.y);
  if (!(over_m < low_.most_m))  // or unknown
  {
    return pass.to_m;
  }
  const float fall = ground_.slopeAt(end.x, end.y, way.ray.to) - pass.slope;
  const float way_m = (low_.most_m - over_m) / std::max(fall, kLeastFall);
  return pass.to_m - kMargin * way_m - cell_m_;
}

/** Frees the cells where the beam is low. */
void FanTrace::freeAlong(const GroundWay& way, const Pass& pass)
{
  const LocalGround::View ground = ground_;
  const layers::WrappedGrid<UnitCell>::View cells = cells_;
  const geometry::CellIndex first = scene_.region.min;
  const Low low = low_;
  const Pass p = pass;
  const float from_m = origin_.z();
  const float robot_m = scene_.rules.robot_m();
  CellWalk walk(way, p.from_m);
  do
  {
    if (walk.at_m() >= p.to_m)
    {
      return;
    }
    const float along_m = std::min(walk.middle_m(), p.to_m);
    const GroundRay::Place place = walk.place();
    const float ground_m = ground.heightAt(place.x, place.y);
    if (low.holds(from_m + p.slope * along_m - ground_m, along_m))
    {
      const float top_m = std::clamp(from_m + p.top_slope * along_m - ground_m, 0.0F, robot_m);
      const auto steps = static_cast<int32_t>(top_m / static_cast<float>(kFreeStep_m) + 0.01F);
      setFree(cells.at({first.x + place.x, first.y + place.y}), std::min(steps, 255));
    }
  } while (walk.next());
}
}  // namespace traverse::multi_lidar_grid
