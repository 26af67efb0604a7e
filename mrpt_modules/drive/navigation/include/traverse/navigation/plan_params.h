// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/options/option.h>

#include <array>
#include <concepts>
#include <cstdint>
#include <string_view>
#include <type_traits>
#include <utility>

namespace traverse::navigation
{
/** How a way is sought. */
enum class PlannerKind : uint8_t
{
  fitting,  //!< "auto": grid for vehicles that turn on the spot, hybrid for car-like ones
  grid,     //!< over cells
  hybrid,   //!< over cells and headings, by arcs that the vehicle can drive
};

/** Section [Planner]. */
struct PlanParams
{
  PlannerKind planner = PlannerKind::fitting;
  double stray_m = 1.0;
  double goal_tolerance_m = 0.5;
  double reverse_price = 3;
  double turn_price = 1;
  double margin_m = 0.15;
  int most_expansions = 60000;

  friend bool operator==(const PlanParams&, const PlanParams&) = default;
};

template <class P, class F>
requires std::same_as<std::remove_const_t<P>, PlanParams>

void visit(P& p, F&& f)
{
  using options::Option;
  f(Option{"planner", "auto: grid for vehicles that turn on the spot, hybrid for car-like ones"},
    p.planner);
  f(Option{"stray_m", "further from its path the vehicle needs a new one, m", {0.05, 100}},
    p.stray_m);
  f(Option{"goal_tolerance_m", "so near the goal is reached, m", {0.01, 100}}, p.goal_tolerance_m);
  f(Option{"reverse_price", "hybrid: a metre backward costs so many forward", {1, 1000}},
    p.reverse_price);
  f(
      Option{
          "turn_price", "hybrid: changing between forward and backward costs so much, m", {0, 100}},
      p.turn_price);
  f(
      Option{
          "margin_m",
          "hybrid: its ways keep the outline so far off obstacle cells, m; without where there is "
          "none",
          {0, 5}},
      p.margin_m);
  f(Option{"most_expansions", "hybrid: it gives up after so many", {100, 100000000}},
    p.most_expansions);
}
}  // namespace traverse::navigation

template <>
struct traverse::options::EnumNames<traverse::navigation::PlannerKind>
{
  using E = traverse::navigation::PlannerKind;
  static constexpr std::array<std::pair<E, std::string_view>, 3> kNames = {
      {{E::fitting, "auto"}, {E::grid, "grid"}, {E::hybrid, "hybrid"}}};
};
