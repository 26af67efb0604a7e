// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "places.h"

#include <traverse/geometry/exact_trig.h>

#include <cmath>
#include <stdexcept>
#include <utility>

namespace traverse::reactive
{
namespace
{
/** Whether no arc leads there, forward or backward: it lies within a circle that the vehicle turns
 * on. */
bool isInTurningCircle(const Eigen::Vector2d& p, double radius_m)
{
  return p.squaredNorm() < 2 * radius_m * std::abs(p.y());
}
}  // namespace

Places::Places(std::vector<Eigen::Vector2d> places, const Limits& limits_m) :
    places_(std::move(places)), limits_m_(limits_m)
{
  for (const Eigen::Vector2d& place : places_)
  {
    if (!place.allFinite())
    {
      throw std::invalid_argument("a place to drive to is not finite");
    }
  }
}

bool Places::goOn(const geometry::Pose2& pose)
{
  const size_t before = next_;
  while (next_ + 1 < places_.size() && isPassed(next_, pose))
  {
    ++next_;
  }
  return next_ != before;
}

bool Places::skip()
{
  const bool can = next_ + 1 < places_.size();
  next_ += can ? 1 : 0;
  return can;
}

bool Places::isOver(const geometry::Pose2& pose) const
{
  return next_ + 1 == places_.size() &&
         (places_.back() - Eigen::Vector2d(pose.x_m, pose.y_m)).norm() < limits_m_.goal_tolerance;
}

bool Places::isPassed(size_t n, const geometry::Pose2& pose) const
{
  const Eigen::Vector2d to_place = places_[n] - Eigen::Vector2d(pose.x_m, pose.y_m);
  const geometry::SinCos yaw = geometry::sinCosOf(pose.yaw_rad);
  const Eigen::Vector2d p_vehicle(
      yaw.cos * to_place.x() + yaw.sin * to_place.y(),
      yaw.cos * to_place.y() - yaw.sin * to_place.x());
  if (to_place.norm() < limits_m_.tolerance ||
      isInTurningCircle(p_vehicle, limits_m_.turning_radius))
  {
    return true;
  }
  // Beyond the lines through the place across the way to it and across the way from it.
  const bool has_come = n == 0 || to_place.dot(places_[n] - places_[n - 1]) < 0;
  return to_place.norm() < limits_m_.near && has_come &&
         to_place.dot(places_[n + 1] - places_[n]) < 0;
}
}  // namespace traverse::reactive
