// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "moving_thing.h"

#include <algorithm>
#include <cmath>

namespace traverse::simulation
{
namespace
{
SurfaceSoup soupOf(const Object& object, uint32_t number)
{
  SurfaceSoup soup(Eigen::Vector3d::Zero());
  soup.add(object, number, Eigen::Isometry3d::Identity());
  return soup;
}

double radiusOf(const Object& object)
{
  float farthest_m = 0;
  for (const Part& part : object.parts)
  {
    for (const Eigen::Vector3f& v : part.vertices)
    {
      farthest_m = std::max(farthest_m, v.norm());
    }
  }
  for (const Ball& ball : object.balls)
  {
    farthest_m = std::max(farthest_m, ball.centre.norm() + ball.radius_m);
  }
  return static_cast<double>(farthest_m);
}
}  // namespace

MovingThing::MovingThing(RTCDeviceTy* device, const Object& object, uint32_t number) :
    motion_(object.motion), scene_(device, soupOf(object, number)), radius_m_(radiusOf(object))
{
  const double from_s = motion_.poses().front().t_s;
  const double while_count = (motion_.poses().back().t_s - from_s) / kWhile_s;
  const auto count = static_cast<size_t>(std::ceil(while_count)) + 1;
  bounds_.reserve(count);
  for (size_t i = 0; i < count; ++i)
  {
    bounds_.push_back(boundAround(from_s + static_cast<double>(i) * kWhile_s));
  }
}

MovingThing::Bound MovingThing::boundAround(double from_s) const
{
  // Looked at often enough that nothing on wheels or legs leaves the way between two looks.
  constexpr int kLooks = 4;
  const Eigen::Vector3d centre = motion_.at(from_s + kWhile_s / 2).translation();
  double farthest_m = 0;
  for (int look = 0; look <= kLooks; ++look)
  {
    const double t_s = from_s + kWhile_s * look / kLooks;
    farthest_m = std::max(farthest_m, (motion_.at(t_s).translation() - centre).norm());
  }
  return {centre, radius_m_ + 1.5 * farthest_m + 1e-3};
}

const MovingThing::Bound& MovingThing::boundAt(double t_s) const
{
  const double at = (t_s - motion_.poses().front().t_s) / kWhile_s;
  const double last = static_cast<double>(bounds_.size() - 1);
  return bounds_[static_cast<size_t>(std::clamp(at, 0.0, last))];
}

bool MovingThing::cast(
    const Eigen::Vector3d& origin,
    const Eigen::Vector3d& direction,
    double t_s,
    double max_m,
    SoupHit& hit) const
{
  const Bound& bound = boundAt(t_s);
  const Eigen::Vector3d to_centre = bound.centre - origin;
  const double along_m = to_centre.dot(direction);
  const double aside2 = to_centre.squaredNorm() - along_m * along_m;
  if (aside2 > bound.radius_m * bound.radius_m || along_m < -bound.radius_m ||
      along_m > max_m + bound.radius_m)
  {
    return false;
  }
  const Eigen::Isometry3d T_body_map = motion_.at(t_s).inverse();
  return scene_.cast(T_body_map * origin, T_body_map.linear() * direction, max_m, hit);
}
}  // namespace traverse::simulation
