// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "speed_limits.h"

#include <algorithm>
#include <cmath>

namespace traverse::navigation
{
namespace
{
/** From one point of the path to the next. */
struct Leg
{
  double length_m;
  double curvature_1pm;
};

Leg legOf(const Path& path, size_t i)
{
  const double length_m = path[i + 1].along_m - path[i].along_m;
  const double curvature = std::abs(path[i].curvature_1pm);
  return {length_m > 0 ? length_m : 0, curvature > 0 ? curvature : 0};
}

/** The speed at the faster end of a leg, from the slower one at most_mps2, such that at the faster
 * end
 *
 *   a^2 + (k u)^2 = sum^2,   u = slow^2 + 2 a length
 *
 * at most: what the curve takes of the grip is not there to brake with. */
double fasterEnd(double slow_mps, const Leg& leg, double most_mps2, double sum_mps2)
{
  const double u = slow_mps * slow_mps;
  const double k2 = leg.curvature_1pm * leg.curvature_1pm;
  const double a = 1 + 4 * k2 * leg.length_m * leg.length_m;
  const double half_b = 2 * k2 * u * leg.length_m;
  const double c = k2 * u * u - sum_mps2 * sum_mps2;
  const double root = half_b * half_b - a * c;
  const double by_grip = c < 0 ? (std::sqrt(root) - half_b) / a : 0;
  return std::sqrt(u + 2 * std::min(most_mps2, by_grip) * leg.length_m);
}

void passBackward(const Path& path, const std::vector<Grip>& grips, std::vector<SpeedLimit>& limits)
{
  for (size_t i = path.size() - 1; i-- > 0;)
  {
    const Grip grip = weaker(grips[i], grips[i + 1]);
    const double most =
        fasterEnd(limits[i + 1].speed_mps, legOf(path, i), grip.brake_mps2, grip.sum_mps2);
    if (most < limits[i].speed_mps)
    {
      limits[i] = {most, limits[i + 1].reason};
    }
  }
}

void passForward(
    const Path& path,
    double accel_mps2,
    const std::vector<Grip>& grips,
    std::vector<SpeedLimit>& limits)
{
  for (size_t i = 1; i < path.size(); ++i)
  {
    const Grip grip = weaker(grips[i - 1], grips[i]);
    const double most =
        fasterEnd(limits[i - 1].speed_mps, legOf(path, i - 1), accel_mps2, grip.sum_mps2);
    if (most < limits[i].speed_mps)
    {
      limits[i] = {most, SpeedReason::vehicle};
    }
  }
}
}  // namespace

std::string_view nameOf(SpeedReason reason)
{
  switch (reason)
  {
    case SpeedReason::vehicle:
      return "vehicle";
    case SpeedReason::curve:
      return "curve";
    case SpeedReason::ground:
      return "ground";
    case SpeedReason::unknown:
      return "unknown";
    case SpeedReason::end:
      return "end";
    case SpeedReason::clearance:
      return "clearance";
    case SpeedReason::grip:
      return "grip";
  }
  return "none";
}

std::vector<SpeedLimit> speedProfile(
    const Path& path,
    const Costmap& costmap,
    const geometry::Drivetrain& drivetrain,
    double speed_mps,
    const SpeedParams& params)
{
  const std::vector<Grip> grips = gripsAlong(path, costmap, drivetrain, params);
  const std::vector<SpeedLimit> by_place = limitsByPlace(path, grips, costmap, drivetrain, params);
  std::vector<SpeedLimit> limits = by_place;
  if (path.empty())
  {
    return limits;
  }
  passBackward(path, grips, limits);
  const double start_mps = std::max(std::abs(speed_mps), params.creep_mps);
  if (start_mps < limits.front().speed_mps)
  {
    limits.front() = {start_mps, SpeedReason::vehicle};
  }
  passForward(path, drivetrain.max_accel_mps2, grips, limits);
  for (size_t i = 0; i < limits.size(); ++i)
  {
    const double creep = std::min(params.creep_mps, by_place[i].speed_mps);
    limits[i].speed_mps = std::max(limits[i].speed_mps, creep);
  }
  return limits;
}
}  // namespace traverse::navigation
