// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/options/option.h>

#include <vector>

namespace traverse::geometry
{
/** What drives: section [Vehicle] of every ini, used by all maps. Vehicle frame: x forward, y left,
 * z up, origin = the reference that MRPT's sensorPose is given in. */
struct Vehicle
{
  std::vector<double> footprint_xs_m = {-0.5, 0.5, 0.5, -0.5};
  std::vector<double> footprint_ys_m = {-0.4, -0.4, 0.4, 0.4};
  double height_m = 2.0;
  double base_height_m = 0.0;
  double max_step_m = 0.15;
  double max_slope_deg = 20.0;

  friend bool operator==(const Vehicle&, const Vehicle&) = default;
};

template <class P, class F>
void visitVehicle(P& p, F&& f)
{
  using options::Option;
  f(
      Option{
          "footprint_xs_m",
          "outline of the vehicle seen from above, x of its corners, m",
          {-50, 50}},
      p.footprint_xs_m);
  f(Option{"footprint_ys_m", "the same corners' y, m", {-50, 50}}, p.footprint_ys_m);
  f(
      Option{
          "height_m",
          "height of the vehicle over the ground, m: what hangs higher is no obstacle",
          {0.05, 20}},
      p.height_m);
  f(
      Option{
          "base_height_m",
          "height of the vehicle frame's origin over the ground it stands on, m",
          {-5, 20}},
      p.base_height_m);
  f(Option{"max_step_m", "highest step that the wheels take, m", {0, 5}}, p.max_step_m);
  f(Option{"max_slope_deg", "steepest slope that the vehicle takes, deg", {0, 89}},
    p.max_slope_deg);
}

template <class F>
void visit(Vehicle& p, F&& f)
{
  visitVehicle(p, f);
}

template <class F>
void visit(const Vehicle& p, F&& f)
{
  visitVehicle(p, f);
}
}  // namespace traverse::geometry
