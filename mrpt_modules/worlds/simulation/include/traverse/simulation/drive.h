// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/vehicle.h>
#include <traverse/options/option.h>
#include <traverse/simulation/motion.h>
#include <traverse/simulation/scene.h>

#include <vector>

namespace traverse::simulation
{
/** Section [Drive]: where the vehicle drives. */
struct DriveParams
{
  std::vector<double> xs_m = {0, 40};
  std::vector<double> ys_m = {0, 0};
  double speed_mps = 8;
  double accel_mps2 = 2;
  double start_s = 0;
  double duration_s = 0;

  friend bool operator==(const DriveParams&, const DriveParams&) = default;
};

template <class P, class F>
void visitDriveParams(P& p, F&& f)
{
  using options::Option;
  f(Option{"xs_m", "the points that the vehicle drives through, x on the map, m", {-1e5, 1e5}},
    p.xs_m);
  f(Option{"ys_m", "the same points' y, m", {-1e5, 1e5}}, p.ys_m);
  f(Option{"speed_mps", "its speed, m/s", {0.01, 60}}, p.speed_mps);
  f(
      Option{
          "accel_mps2",
          "how it drives off and stops, m/s2; 0: it has its speed from the first moment to the "
          "last",
          {0, 50}},
      p.accel_mps2);
  f(Option{"start_s", "it stands for so long first, s", {0, 3600}}, p.start_s);
  f(
      Option{
          "duration_s",
          "the recording takes so long, s; 0: until the vehicle is at the end of its line",
          {0, 3600}},
      p.duration_s);
}

template <class F>
void visit(DriveParams& p, F&& f)
{
  visitDriveParams(p, f);
}

template <class F>
void visit(const DriveParams& p, F&& f)
{
  visitDriveParams(p, f);
}

/** From one pose of a drive to the next, s. */
inline constexpr double kDriveStepSeconds = 0.01;

/** The vehicle frame's way over the ground: a natural cubic spline through the points (heading and
 * curvature are continuous), poses every 10 ms from 0 s to the end of the recording. Height, roll
 * and pitch are those of the plane through the ground under the four corners of the footprint's
 * box, each smoothed over 0.6 m of the way twice, as wheels and springs do.
 *
 * Throws std::invalid_argument where the points are no line (not as many xs as ys, two of them in
 * one place, longer than 100 km), an option is out of its range, or the drive takes no time. The
 * same bits everywhere. */
Motion driveOn(const Terrain& terrain, const DriveParams& params, const geometry::Vehicle& vehicle);
}  // namespace traverse::simulation
