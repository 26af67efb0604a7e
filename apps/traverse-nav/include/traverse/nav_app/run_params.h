// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/options/option.h>

#include <array>
#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace traverse::app
{
/** Where the vehicle takes its poses from. */
enum class NavPoses : uint8_t
{
  exact,   //!< the simulator's
  icp_3d,  //!< odometry put right by scans that are matched to a map (registration)
};

/** Section [traverse-nav]. */
struct NavParams
{
  std::string title = "drive";
  std::string scene;
  NavPoses poses = NavPoses::exact;
  double control_hz = 20;
  double costmap_hz = 5;
  double max_time_s = 300;
  std::vector<double> goal_xs_m;
  std::vector<double> goal_ys_m;
  double goal_every_m = 30;
  double frames_every_s = 0;

  friend bool operator==(const NavParams&, const NavParams&) = default;
};

template <class P, class F>
requires std::same_as<std::remove_const_t<P>, NavParams>

void visit(P& p, F&& f)
{
  using options::Option;
  f(Option{"title", "of the report"}, p.title);
  f(Option{"scene", "the world to drive in: a scene file of traverse-sim, from this ini's folder"},
    p.scene);
  f(
      Option{
          "poses",
          "exact: the simulator's; icp_3d: odometry with drift, put right by matched scans"},
      p.poses);
  f(Option{"control_hz", "commands a second", {5, 100}}, p.control_hz);
  f(
      Option{
          "costmap_hz",
          "how often the maps are looked at, 1/s; never more often than they change",
          {0.5, 100}},
      p.costmap_hz);
  f(Option{"max_time_s", "then the mission has failed, s", {1, 36000}}, p.max_time_s);
  f(
      Option{
          "goal_xs_m",
          "the places to reach, one after the other, x on the map, m; empty: the scene's",
          {-1e5, 1e5}},
      p.goal_xs_m);
  f(Option{"goal_ys_m", "the same places' y, m", {-1e5, 1e5}}, p.goal_ys_m);
  f(
      Option{
          "goal_every_m",
          "replay: places of the recorded way to go to, where there are no goal_xs_m, m",
          {2, 10000}},
      p.goal_every_m);
  f(
      Option{
          "frames_every_s",
          "drive.gif gets a picture of costs, way and vehicle so often, s; 0: there is none",
          {0, 3600}},
      p.frames_every_s);
}
}  // namespace traverse::app

template <>
struct traverse::options::EnumNames<traverse::app::NavPoses>
{
  using E = traverse::app::NavPoses;
  static constexpr std::array<std::pair<E, std::string_view>, 2> kNames = {
      {{E::exact, "exact"}, {E::icp_3d, "icp_3d"}}};
};
