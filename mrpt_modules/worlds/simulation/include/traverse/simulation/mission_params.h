// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/pose2.h>
#include <traverse/options/option.h>

#include <concepts>
#include <type_traits>
#include <vector>

namespace traverse::simulation
{
/** Section [Mission]: where a navigator begins, and where it is to go, goal by goal. */
struct MissionParams
{
  double start_x_m = 0;
  double start_y_m = 0;
  double start_yaw_deg = 0;
  std::vector<double> goal_xs_m;
  std::vector<double> goal_ys_m;

  friend bool operator==(const MissionParams&, const MissionParams&) = default;
};

template <class P, class F>
requires std::same_as<std::remove_const_t<P>, MissionParams>

void visit(P& p, F&& f)
{
  using options::Option;
  f(Option{"start_x_m", "where the vehicle begins: x on the map, m", {-1e5, 1e5}}, p.start_x_m);
  f(Option{"start_y_m", "y of that place, m", {-1e5, 1e5}}, p.start_y_m);
  f(Option{"start_yaw_deg", "where it looks then, against x, deg", {-360, 360}}, p.start_yaw_deg);
  f(Option{"goal_xs_m", "where it is to go, one after the other: x, m", {-1e5, 1e5}}, p.goal_xs_m);
  f(Option{"goal_ys_m", "the same goals' y, m", {-1e5, 1e5}}, p.goal_ys_m);
}

geometry::Pose2 startOf(const MissionParams& mission);

/** In their order; each looks the way that leads to it from the goal before (or the start). Empty:
 * there is no mission. Throws options::OptionError where there are not as many x as y. */
std::vector<geometry::Pose2> goalsOf(const MissionParams& mission);
}  // namespace traverse::simulation
