// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/navigation/footprint.h>
#include <traverse/navigation/path.h>

#include <span>
#include <vector>

namespace traverse::navigation
{
/** A piece of a way that a car-like vehicle drives with its wheels held. */
struct Motion
{
  double curvature_1pm = 0;  //!< wheels to the left positive, also backward
  double length_m = 0;       //!< negative: backward
};

/** A pose with the sine and cosine of its heading. */
struct Posed
{
  Stand stand;
  double yaw_rad = 0;  //!< in [-pi, pi]
};

inline Posed posed(const geometry::Pose2& pose)
{
  const double yaw_rad = std::remainder(pose.yaw_rad, 2 * geometry::kPi);
  return {{{pose.x_m, pose.y_m}, geometry::sinCosOf(yaw_rad)}, yaw_rad};
}

/** Where a motion leads to, seen from where it began. */
struct Shift
{
  double x_m = 0;
  double y_m = 0;
  double yaw_rad = 0;
  geometry::SinCos yaw;
};

inline Shift shiftOf(const Motion& motion)
{
  const double turn = motion.curvature_1pm * motion.length_m;
  const geometry::SinCos v = geometry::sinCosOf(turn);
  constexpr double kStraight = 1e-9;
  if (std::abs(turn) < kStraight)
  {
    return {motion.length_m, turn * motion.length_m / 2, turn, v};
  }
  const double versine = v.cos > 0 ? v.sin * v.sin / (1 + v.cos) : 1 - v.cos;
  return {v.sin / motion.curvature_1pm, versine / motion.curvature_1pm, turn, v};
}

inline Posed after(const Posed& from, const Shift& shift)
{
  const geometry::SinCos& a = from.stand.yaw;
  const double yaw_rad = from.yaw_rad + shift.yaw_rad;
  return {
      {{from.stand.place.x_m + shift.x_m * a.cos - shift.y_m * a.sin,
        from.stand.place.y_m + shift.x_m * a.sin + shift.y_m * a.cos},
       {a.sin * shift.yaw.cos + a.cos * shift.yaw.sin,
        a.cos * shift.yaw.cos - a.sin * shift.yaw.sin}},
      std::abs(yaw_rad) <= geometry::kPi ? yaw_rad : std::remainder(yaw_rad, 2 * geometry::kPi)};
}

/** Shifts to places every 10 cm or less along a motion, the last one to its end. */
std::vector<Shift> stepsOf(const Motion& motion);

/** Adds the places of a motion to a path that ends where it begins (or is empty). */
void drive(Path& path, const Posed& from, const Motion& motion);
}  // namespace traverse::navigation
