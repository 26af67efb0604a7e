// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "places.h"

#include <traverse/geometry/frame2.h>

#include <algorithm>
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

bool Places::goOn(const geometry::Pose2& pose, const std::vector<Eigen::Vector3f>& obstacles)
{
  const size_t before = next_;
  while (next_ + 1 < places_.size() && (isPassed(next_, pose) || isBlocked(next_, pose, obstacles)))
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

bool Places::isBlocked(
    size_t n, const geometry::Pose2& pose, const std::vector<Eigen::Vector3f>& obstacles) const
{
  const Eigen::Vector2d place = geometry::Frame2::of(pose).in(places_[n]);
  const double most_m2 = limits_m_.half_width * limits_m_.half_width;
  return place.norm() < 2 * limits_m_.near &&
         std::any_of(
             obstacles.begin(), obstacles.end(),
             [&](const Eigen::Vector3f& p)
             { return (p.head<2>().cast<double>() - place).squaredNorm() < most_m2; });
}

bool Places::isPassed(size_t n, const geometry::Pose2& pose) const
{
  const Eigen::Vector2d to_place = places_[n] - Eigen::Vector2d(pose.x_m, pose.y_m);
  if (to_place.norm() < limits_m_.tolerance ||
      isInTurningCircle(geometry::Frame2::of(pose).in(places_[n]), limits_m_.turning_radius))
  {
    return true;
  }
  // Beyond the lines through the place across the way to it and across the way from it.
  const bool has_come = n == 0 || to_place.dot(places_[n] - places_[n - 1]) < 0;
  return to_place.norm() < limits_m_.near && has_come &&
         to_place.dot(places_[n + 1] - places_[n]) < 0;
}
}  // namespace traverse::reactive
