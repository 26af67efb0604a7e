// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "speed_limits.h"

#include "room.h"

#include <traverse/geometry/exact_trig.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace traverse::navigation
{
namespace
{
using geometry::CellIndex;
using geometry::Drivetrain;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();  // friction

void lower(SpeedLimit& limit, double speed_mps, SpeedReason reason)
{
  if (speed_mps < limit.speed_mps)
  {
    limit = {speed_mps, reason};
  }
}

/** Nothing where the place is no place. */
std::optional<CellIndex> cellOf(const Costmap& costmap, const PathPoint& point)
{
  constexpr double kFarthest_m = 1e6;
  const bool is_place =
      std::abs(point.pose.x_m) <= kFarthest_m && std::abs(point.pose.y_m) <= kFarthest_m;
  return is_place ? std::optional(costmap.cellAt(point.pose.x_m, point.pose.y_m)) : std::nullopt;
}

/** The sharper of the ways to and from a point. */
double curvatureAt(const Path& path, size_t i)
{
  const double after = std::abs(path[i].curvature_1pm);
  return i > 0 ? std::max(after, std::abs(path[i - 1].curvature_1pm)) : after;
}

double curveSpeed(double curvature_1pm, const Drivetrain& drivetrain, const Grip& grip)
{
  if (!(curvature_1pm > 0))
  {
    return kInfinity;
  }
  double speed = std::sqrt(grip.lateral_mps2 / curvature_1pm);
  if (drivetrain.steering == geometry::Steering::differential)
  {
    const double turn_radps = drivetrain.max_yaw_rate_degps * geometry::kPi / 180;
    speed = std::min(speed, turn_radps / curvature_1pm);
  }
  return speed;
}

/** Nobody has seen it, and it is more than a gap between beams. */
bool isUnseen(const Costmap& costmap, CellIndex c)
{
  const auto is_unknown = [&](int32_t x, int32_t y) {
    return costmap.passageAt({x, y}) == Passage::unknown;
  };
  return is_unknown(c.x, c.y) && (is_unknown(c.x - 1, c.y) || is_unknown(c.x + 1, c.y) ||
                                  is_unknown(c.x, c.y - 1) || is_unknown(c.x, c.y + 1));
}

/** The speed from which it stops within a way: way = v reaction + v^2 / (2 brake). */
double stoppingSpeed(double way_m, double brake_mps2, double reaction_s)
{
  const double lost = brake_mps2 * reaction_s;
  return std::sqrt(lost * lost + 2 * brake_mps2 * std::max(way_m, 0.0)) - lost;
}

void limitByUnknown(
    const Path& path,
    const Costmap& costmap,
    const std::vector<Grip>& grips,
    const SpeedParams& params,
    std::vector<SpeedLimit>& limits)
{
  double unknown_at_m = kInfinity;
  double brake_mps2 = 0;  // the worst from here to there
  for (size_t i = path.size(); i-- > 0;)
  {
    const std::optional<CellIndex> c = cellOf(costmap, path[i]);
    const bool is_unseen = !c || isUnseen(costmap, *c);
    unknown_at_m = is_unseen ? path[i].along_m : unknown_at_m;
    brake_mps2 = is_unseen ? grips[i].brake_mps2 : std::min(brake_mps2, grips[i].brake_mps2);
    if (unknown_at_m < kInfinity)
    {
      lower(
          limits[i], stoppingSpeed(unknown_at_m - path[i].along_m, brake_mps2, params.reaction_s),
          SpeedReason::unknown);
    }
  }
}

void limitByCells(
    const Path& path,
    const Costmap& costmap,
    const SpeedParams& params,
    std::vector<SpeedLimit>& limits)
{
  constexpr double kMostRoom_m = 2;  // looking further is not worth its time
  for (size_t i = 0; i < path.size(); ++i)
  {
    const std::optional<CellIndex> c = cellOf(costmap, path[i]);
    if (!c || !costmap.extent.contains(*c))
    {
      continue;
    }
    lower(
        limits[i], static_cast<double>(costmap.speed_mps[costmap.indexOf(*c)]),
        SpeedReason::ground);
    const double room_m = std::min(kMostRoom_m, limits[i].speed_mps * params.reaction_s);
    const auto reach_cells = static_cast<int32_t>(room_m / costmap.lattice.cell_m());
    if (params.reaction_s > 0)
    {
      lower(
          limits[i], roomAt(costmap, *c, reach_cells) / params.reaction_s, SpeedReason::clearance);
    }
  }
}

/** A car's wheels turn from one arc's curvature to the next one's on so much of the way, half of it
 * before the place where the arcs meet. */
void limitBySteering(
    const Path& path, const Drivetrain& drivetrain, std::vector<SpeedLimit>& limits)
{
  const double way_m = 0.8 * drivetrain.wheelbase_m;
  const auto steer_rad = [&](double curvature_1pm)
  { return geometry::angleOf(curvature_1pm * drivetrain.wheelbase_m, 1); };
  for (size_t i = 1; i < path.size(); ++i)
  {
    const double change_rad =
        std::abs(steer_rad(path[i].curvature_1pm) - steer_rad(path[i - 1].curvature_1pm));
    const double most_mps =
        way_m * drivetrain.max_steer_rate_degps * geometry::kPi / 180 / change_rad;
    if (most_mps >= limits[i].speed_mps)
    {
      continue;
    }
    const double before_m = path[i].along_m - way_m / 2;
    const double after_m = path[i].along_m + way_m / 2;
    for (size_t j = i; j-- > 0 && path[j].along_m >= before_m;)
    {
      lower(limits[j], most_mps, SpeedReason::curve);
    }
    for (size_t j = i; j < path.size() && path[j].along_m <= after_m; ++j)
    {
      lower(limits[j], most_mps, SpeedReason::curve);
    }
  }
}
}  // namespace

std::vector<Grip> gripsAlong(
    const Path& path,
    const Costmap& costmap,
    const Drivetrain& drivetrain,
    const SpeedParams& params)
{
  std::vector<Grip> grips(path.size(), gripOn(kUnknown, drivetrain, params));
  for (size_t i = 0; i < path.size() && !costmap.friction.empty(); ++i)
  {
    const std::optional<CellIndex> c = cellOf(costmap, path[i]);
    grips[i] = gripOn(c ? costmap.frictionAt(*c) : kUnknown, drivetrain, params);
  }
  return grips;
}

std::vector<SpeedLimit> limitsByPlace(
    const Path& path,
    const std::vector<Grip>& grips,
    const Costmap& costmap,
    const Drivetrain& drivetrain,
    const SpeedParams& params)
{
  const Grip usual = gripOn(kUnknown, drivetrain, params);
  std::vector<SpeedLimit> limits(path.size());
  for (size_t i = 0; i < path.size(); ++i)
  {
    limits[i].speed_mps =
        path[i].is_backward ? drivetrain.max_reverse_mps : drivetrain.max_speed_mps;
    const double curvature_1pm = curvatureAt(path, i);
    const double most_mps = curveSpeed(curvature_1pm, drivetrain, grips[i]);
    const bool is_slippery = most_mps < curveSpeed(curvature_1pm, drivetrain, usual);
    lower(limits[i], most_mps, is_slippery ? SpeedReason::grip : SpeedReason::curve);
  }
  if (drivetrain.steering == geometry::Steering::ackermann)
  {
    limitBySteering(path, drivetrain, limits);
  }
  limitByUnknown(path, costmap, grips, params, limits);
  limitByCells(path, costmap, params, limits);
  for (size_t i = 0; i < path.size(); ++i)
  {
    const double most = path[i].is_backward ? drivetrain.max_reverse_mps : drivetrain.max_speed_mps;
    limits[i].speed_mps = std::max(limits[i].speed_mps, std::min(params.creep_mps, most));
    const bool turns_round = i > 0 && path[i].is_backward != path[i - 1].is_backward;
    if (i + 1 == path.size() || turns_round)
    {
      limits[i] = {0, SpeedReason::end};
    }
  }
  return limits;
}
}  // namespace traverse::navigation
