// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/exact_trig.h>
#include <traverse/geometry/outline.h>
#include <traverse/geometry/pose2.h>

#include <Eigen/Geometry>

#include <cmath>

namespace traverse::geometry
{
/** A frame seen from above; takes places between it and the frame that it lies in, m. The same bits
 * on every processor. */
struct Frame2
{
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();
  Eigen::Vector2d axis = Eigen::Vector2d::UnitX();  //!< its x

  static Frame2 of(const Eigen::Isometry3d& T)
  {
    const Eigen::Vector2d x = T.linear().col(0).head<2>();
    return {T.translation().head<2>(), x / std::sqrt(x.dot(x))};
  }

  /** NaN where the heading is not finite. */
  static Frame2 of(const Pose2& pose)
  {
    const auto [s, c] = sinCosOfAny(pose.yaw_rad);
    return {{pose.x_m, pose.y_m}, {c, s}};
  }

  /** A place of the frame, in the one that it lies in. */
  Eigen::Vector2d out(const Eigen::Vector2d& p) const
  {
    return {
        origin.x() + axis.x() * p.x() - axis.y() * p.y(),
        origin.y() + axis.y() * p.x() + axis.x() * p.y()};
  }

  /** The reverse. */
  Eigen::Vector2d in(const Eigen::Vector2d& p) const
  {
    const Eigen::Vector2d d = p - origin;
    return {axis.x() * d.x() + axis.y() * d.y(), axis.x() * d.y() - axis.y() * d.x()};
  }

  Outline out(const Outline& outline) const
  {
    Outline placed;
    for (const Eigen::Vector2d& p : outline)
    {
      placed.push_back(out(p));
    }
    return placed;
  }

  Outline in(const Outline& outline) const
  {
    Outline seen;
    for (const Eigen::Vector2d& p : outline)
    {
      seen.push_back(in(p));
    }
    return seen;
  }
};
}  // namespace traverse::geometry
