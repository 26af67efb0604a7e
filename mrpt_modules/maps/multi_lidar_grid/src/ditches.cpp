// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fan_trace.h"

#include <algorithm>
#include <cmath>

// Where the ground falls away. A fan's beams land further and further out; the ground between two
// landings is taken to go on straight from the nearer one. A beam that lands lower than that has
// passed over something: a ditch, a kerb, or a slope that begins there. What tells them apart is
// where the next beam lands: carried back straight to the nearer landing, a slope comes out at the
// ground's height, and a kerb does not; behind a ditch the surface rises again.
namespace traverse::multi_lidar_grid
{
using layers::OccupancyState;

namespace
{
/** A beam that lands so far below the straight ground has sunk: the noise of its range and the
 * ground's own unevenness, which grows from landing to landing. */
float leastSink(float reach_m, float step_m)
{
  return 0.06F + 0.004F * reach_m + 0.03F * step_m;
}

/** Behind a ditch whose floor nobody sees the surface rises by more than so much per metre. */
constexpr float kRises = 0.15F;

/** The slope at a landing is that from the last one this far before it. */
constexpr float kSlopeOver_m = 0.5F;

/** Of a wall: no two landings are nearer. */
constexpr float kLeastStep_m = 0.05F;

/** The ground is not carried on further. */
constexpr float kFurthest_m = 8;

float heightOf(const FanBeam& beam)
{
  return beam.slope * beam.reach_m;
}
}  // namespace

/** Looks through a fan for beams that sank. Heights count from the sensor. */
void FanTrace::findDitches(const BeamFans& fans, std::span<const FanBeam> beams)
{
  const GroundWay middle = wayTo(fans.direction(fan_, 0));
  const float most_m = std::min({middle.inside.to_m, scene_.range_m, scene_.rules.ditch_range_m});
  Landing before;
  Landing brink;  // of the last ditch
  for (size_t k = 0; k < beams.size(); ++k)
  {
    const FanBeam& beam = beams[k];
    if (!beam.is_hit || beam.slope >= 0 || beam.reach_m < middle.inside.from_m ||
        beam.reach_m >= most_m)
    {
      continue;
    }
    const float step_m = beam.reach_m - before.reach_m;
    const float sunk_m = before.z_m + before.slope * step_m - heightOf(beam);
    if (before.is_ground && step_m > kLeastStep_m && step_m < kFurthest_m &&
        sunk_m > leastSink(beam.reach_m, step_m))
    {
      sink(fans, before, beams.subspan(k), sunk_m);
      brink = before;
      before = {beam.reach_m, heightOf(beam), before.slope, beam.reach_m, heightOf(beam), true};
      continue;
    }
    markFloor(middle, brink, beam);
    const float over_m = heightOver(middle, beam.slope, beam.reach_m);
    const bool is_ground = std::abs(over_m) <= scene_.rules.obstacle_m();
    before = after(before, beam, is_ground);
    level(middle, over_m, before);
  }
}

/** Over the ground, m; NaN where that is not known. */
float FanTrace::heightOver(const GroundWay& way, float slope, float along_m) const
{
  const GroundRay::Place place = way.placeAt(along_m);
  return origin_.z() + slope * along_m - ground_.heightAt(place.x, place.y);
}

/** What is known at a landing, with the slope of the way to it. */
FanTrace::Landing FanTrace::after(const Landing& before, const FanBeam& beam, bool is_ground) const
{
  Landing here;
  here.reach_m = beam.reach_m;
  here.z_m = heightOf(beam);
  here.is_ground = is_ground;
  if (before.is_ground)
  {
    const bool is_far = beam.reach_m - before.from_m >= kSlopeOver_m;
    here.from_m = is_far ? before.reach_m : before.from_m;
    here.from_z_m = is_far ? before.z_m : before.from_z_m;
    const float way_m = std::max(here.reach_m - here.from_m, kSlopeOver_m);
    const auto most = static_cast<float>(scene_.rules.max_slope);
    here.slope = std::clamp((here.z_m - here.from_z_m) / way_m, -most, most);
  }
  else
  {
    here.from_m = here.reach_m;
    here.from_z_m = here.z_m;
  }
  return here;
}

/** What lies on the ground does not carry it on: neither higher nor steeper up than the ground
 * reference on the way to it. */
void FanTrace::level(const GroundWay& way, float over_m, Landing& landing) const
{
  constexpr float kSlack_m = 0.04F;
  constexpr float kSlackSlope = 0.03F;
  constexpr float kWay_m = 2;
  const float ground_m = landing.z_m - over_m;
  const float earlier_m = heightOver(way, 0, std::max(landing.reach_m - kWay_m, 0.0F));
  const float slope = (ground_m + earlier_m) / kWay_m;  // earlier_m: of the sensor over the ground
  if (slope == slope)
  {
    landing.z_m = std::min(landing.z_m, ground_m + kSlack_m);
    landing.slope = std::min(landing.slope, slope + kSlackSlope);
  }
}

/** The first of `beams` landed lower than the ground goes on. */
void FanTrace::sink(
    const BeamFans& fans, const Landing& before, std::span<const FanBeam> beams, float sunk_m)
{
  const FanBeam& landed = beams.front();
  const float fall = before.slope - landed.slope;
  if (fall <= 0)
  {
    return;
  }
  const float edge_m = std::max(before.reach_m, landed.reach_m - sunk_m / fall);
  if (!isDitch(before, beams, sunk_m, edge_m))
  {
    return;
  }
  const float width = kFansPerDitch * fans.width_rad() * landed.reach_m;
  const int32_t rays = std::clamp(static_cast<int32_t>(std::ceil(width / cell_m_)), 1, 16);
  for (int32_t i = 0; i < rays; ++i)
  {
    const float part = (static_cast<float>(i) + 0.5F) / static_cast<float>(rays) - 0.5F;
    const Direction to = fans.direction(fan_, kFansPerDitch * part);
    markNegative(wayTo(to), edge_m, landed.reach_m);
  }
}

/** The floor of a ditch, where the ground reference has not followed down there. */
void FanTrace::markFloor(const GroundWay& way, const Landing& brink, const FanBeam& beam)
{
  const float step_m = beam.reach_m - brink.reach_m;
  const float sunk_m = brink.z_m + brink.slope * step_m - heightOf(beam);
  if (!brink.is_ground || !(step_m < kFurthest_m) || !(sunk_m >= scene_.rules.depth_m()))
  {
    return;
  }
  const GroundRay::Place place = way.placeAt(beam.reach_m);
  UnitCell& cell = cellAt(place);
  const bool is_met = scene_.columns.find(place.y * edge_ + place.x) != nullptr;
  if (is_met && cell.state == OccupancyState::unknown)
  {
    cell.state = OccupancyState::negative;
  }
}

bool FanTrace::isDitch(
    const Landing& before, std::span<const FanBeam> beams, float sunk_m, float edge_m) const
{
  const FanBeam& landed = beams.front();
  const auto next = std::find_if(
      beams.begin() + 1, beams.end(),
      [&](const FanBeam& b) { return b.is_hit && b.reach_m >= landed.reach_m - kLeastStep_m; });
  if (next == beams.end())
  {
    return false;
  }
  const float step_m = std::max(next->reach_m - landed.reach_m, kLeastStep_m);
  const float next_over_m =
      heightOf(*next) - before.z_m - before.slope * (next->reach_m - before.reach_m);
  const bool is_obstacle = next_over_m > scene_.rules.obstacle_m();
  const float rise = is_obstacle ? 0 : (std::min(next_over_m, 0.0F) + sunk_m) / step_m;
  const float depth_m = scene_.rules.depth_m();
  if (sunk_m >= depth_m)
  {
    return sunk_m + std::min(rise, 0.0F) * (landed.reach_m - before.reach_m) >= depth_m;
  }
  return rise >= kRises && sunk_m + rise * (landed.reach_m - edge_m) >= depth_m;
}

/** Cells without a word of their own, or with returns from below only. */
void FanTrace::markNegative(const GroundWay& way, float from_m, float to_m)
{
  CellWalk walk(way, std::min(from_m, to_m));
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
      cell.up_to = 0;
    }
  } while (walk.next());
}
}  // namespace traverse::multi_lidar_grid
