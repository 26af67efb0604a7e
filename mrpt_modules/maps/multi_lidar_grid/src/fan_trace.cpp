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
/** A beam so far below the ground reference is below the ground: the reference's own error, and
 * that of the sensor's tilt. */
float sunkFrom(float along_m)
{
  constexpr float kReference_m = 0.08F;
  constexpr float kTilt = 0.005F;
  return kReference_m + kTilt * along_m;
}
}  // namespace

void FanTrace::trace(
    const Eigen::Vector3f& origin,
    const BeamFans& fans,
    int32_t fan,
    std::span<const FanBeam> beams)
{
  origin_ = origin;
  fan_ = fan;
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

bool FanTrace::isLow(float height_m, float along_m) const
{
  if (scene_.is_level)
  {
    return height_m > 0 && height_m < scene_.rules.robot_m();
  }
  return height_m < scene_.rules.obstacle_m() && height_m > -sunkFrom(along_m);
}

void FanTrace::follow(const BeamFans& fans, const Pass& pass)
{
  const int32_t rays =
      std::clamp(static_cast<int32_t>(std::ceil(fans.width_rad() * pass.to_m / cell_m_)), 1, 16);
  for (int32_t i = 0; i < rays; ++i)
  {
    const float part = (static_cast<float>(i) + 0.5F) / static_cast<float>(rays) - 0.5F;
    followRay({origin_.x(), origin_.y(), fans.direction(fan_, part)}, pass);
  }
}

void FanTrace::followRay(const GroundRay& ray, const Pass& pass)
{
  const GroundRay::Stretch inside = ray.within(side_m_);
  Pass part = pass;
  part.to_m = std::min(pass.to_m, inside.to_m);
  part.from_m = std::max({pass.from_m, inside.from_m, lowFrom(ray, part)});
  if (part.from_m < part.to_m)
  {
    freeAlong(ray, part);
  }
}

/** A beam comes down to its end: it is low only from here on. */
float FanTrace::lowFrom(const GroundRay& ray, const Pass& pass) const
{
  constexpr float kMargin = 1.5F;  // the ground's slope is that at the end
  constexpr float kLeastFall = 0.005F;
  if (scene_.is_level || pass.to_m <= 0)
  {
    return 0;
  }
  const GroundRay::Place end = ray.placeAt(pass.to_m, 1 / cell_m_, edge_);
  const float end_m = origin_.z() + pass.slope * pass.to_m;
  const float over_m = end_m - scene_.ground.heightAt(end.x, end.y);
  const float most_m = scene_.rules.obstacle_m();
  if (!(over_m < most_m))  // or unknown
  {
    return pass.to_m;
  }
  const float fall = scene_.ground.slopeAt(end.x, end.y, ray.to) - pass.slope;
  const float way_m = (most_m - over_m) / std::max(fall, kLeastFall);
  return pass.to_m - kMargin * way_m - cell_m_;
}

/** Over the ground, m; NaN where that is not known. */
float FanTrace::heightOver(const GroundRay& ray, float slope, float along_m) const
{
  const GroundRay::Place place = ray.placeAt(along_m, 1 / cell_m_, edge_);
  return origin_.z() + slope * along_m - scene_.ground.heightAt(place.x, place.y);
}

/** Frees the cells where the beam is low. */
void FanTrace::freeAlong(const GroundRay& ray, const Pass& pass)
{
  CellWalk walk(ray, pass.from_m, cell_m_, edge_);
  do
  {
    if (walk.at_m() >= pass.to_m)
    {
      return;
    }
    const float along_m = std::min(walk.middle_m(), pass.to_m);
    const float ground_m = scene_.ground.heightAt(walk.place().x, walk.place().y);
    if (isLow(origin_.z() + pass.slope * along_m - ground_m, along_m))
    {
      free(walk.place(), along_m, ground_m, pass);
    }
  } while (walk.next());
}

void FanTrace::free(const GroundRay::Place& place, float along_m, float ground_m, const Pass& pass)
{
  UnitCell& cell = cellAt(place);
  const float top_m = origin_.z() + pass.top_slope * along_m;
  if (cell.state == OccupancyState::obstacle)
  {
    return;
  }
  if (cell.state == OccupancyState::unknown)
  {
    cell.state = cell.hit_from == kHangs ? OccupancyState::overhang : OccupancyState::free;
  }
  if (cell.state == OccupancyState::negative)
  {
    return;
  }
  const float high_m = std::clamp(top_m - ground_m, 0.0F, scene_.rules.robot_m());
  const auto steps = static_cast<int32_t>(high_m / static_cast<float>(kFreeStep_m) + 0.01F);
  cell.up_to = static_cast<uint8_t>(std::max<int32_t>(cell.up_to, std::min(steps, 255)));
}
}  // namespace traverse::multi_lidar_grid
