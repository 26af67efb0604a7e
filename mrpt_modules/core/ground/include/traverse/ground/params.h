// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/options/option.h>

namespace traverse::ground
{
/** How the ground estimate spreads and what it takes for ground. The defaults hold for every sensor
 * and mount that they were tried on; how they were chosen: doc/maps/traversability_grid.md. */
struct Params
{
  double patch_m = 1.0;
  double step_m = 0.15;
  double kerb_m = 0.30;
  double slope_change = 0.15;
  double most_jump_m = 0.6;
  double most_slope_deg = 20;
  double most_gap_m = 30;
  double flat_m = 0.08;
  double over_patch_m = 0.20;
  double over_surface_m = 0.08;
  double at_obstacle_m = 0.03;
  double obstacle_m = 0.25;

  friend bool operator==(const Params&, const Params&) = default;
};

template <class P, class F>
void visitParams(P& p, F&& f)
{
  using options::Option;
  f(
      Option{
          "ground_patch_m",
          "edge of the patches in which the ground spreads, 50 cells at most, m",
          {0.1, 10}},
      p.patch_m);
  f(
      Option{
          "ground_step_m",
          "highest step from patch to patch; the vehicle's max_step_m where that is more, m",
          {0, 2}},
      p.step_m);
  f(Option{"ground_kerb_m", "highest step to a wide and flat surface, as of a pavement, m", {0, 2}},
    p.kerb_m);
  f(
      Option{
          "ground_slope_change",
          "change of slope (metres up per metre) that adds to the step across a gap without points",
          {0, 2}},
      p.slope_change);
  f(Option{"ground_most_jump_m", "step and change of slope together allow no more, m", {0, 10}},
    p.most_jump_m);
  f(
      Option{
          "ground_most_slope_deg",
          "steepest ground; the vehicle's max_slope_deg where that is more, deg",
          {0, 89}},
      p.most_slope_deg);
  f(Option{"ground_most_gap_m", "widest gap without points that the ground crosses, m", {0, 1000}},
    p.most_gap_m);
  f(Option{"ground_flat_m", "a flat cell's heights span no more, m", {0.001, 1}}, p.flat_m);
  f(
      Option{
          "ground_over_patch_m",
          "a cell that begins higher above the patches around it has no ground in it, m",
          {0, 2}},
      p.over_patch_m);
  f(
      Option{
          "ground_over_surface_m",
          "points up to here above the ground of a cell that is not flat are ground, m",
          {0, 2}},
      p.over_surface_m);
  f(Option{"ground_at_obstacle_m", "the same beside and in obstacles, m", {0, 2}}, p.at_obstacle_m);
  f(
      Option{
          "ground_obstacle_m",
          "what rises higher above the ground around it is an obstacle to it, m",
          {0, 10}},
      p.obstacle_m);
}

template <class F>
void visit(Params& p, F&& f)
{
  visitParams(p, f);
}

template <class F>
void visit(const Params& p, F&& f)
{
  visitParams(p, f);
}
}  // namespace traverse::ground
