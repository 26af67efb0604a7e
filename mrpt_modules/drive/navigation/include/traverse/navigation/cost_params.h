// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/layers/safety_buffer.h>
#include <traverse/options/option.h>

#include <array>
#include <concepts>
#include <cstdint>
#include <string_view>
#include <type_traits>
#include <utility>

namespace traverse::navigation
{
/** What the planner makes of cells that no map saw. */
enum class UnknownPolicy : uint8_t
{
  never,   //!< nothing is planned through them (paper 5)
  costly,  //!< at unknown_price
};

/** Section [Costmap]. */
struct CostParams
{
  double cell_size_m = 0.2;
  double window_m = 60;
  UnknownPolicy unknown = UnknownPolicy::costly;
  double unknown_price = 3;
  double hard_buffer_m = 0;
  double soft_buffer_m = 0.6;
  layers::StripRule strip = layers::StripRule::standard;
  double soft_price = 5;
  double index_price = 4;
  double slope_price = 2;
  double grip_price = 4;
  double good_friction = 0.5;
  double friction_sigmas = 2;
  double small_roughness_mps = 1.5;
  double large_roughness_mps = 0.5;

  friend bool operator==(const CostParams&, const CostParams&) = default;
};

/** What friction does to costs, where a map tells it. */
template <class P, class F>
void visitGrip(P& p, F&& f)
{
  using options::Option;
  f(Option{"grip_price", "what ground without any friction adds", {0, 1000}}, p.grip_price);
  f(Option{"good_friction", "from this coefficient of friction on nothing is added, 1", {0.01, 2}},
    p.good_friction);
  f(
      Option{
          "friction_sigmas",
          "a map's friction counts for less by so many of its standard deviations",
          {0, 10}},
      p.friction_sigmas);
}

template <class P, class F>
requires std::same_as<std::remove_const_t<P>, CostParams>

void visit(P& p, F&& f)
{
  using options::Option;
  f(Option{"cell_size_m", "edge of a cell of the costmap, m, to 1 mm", {0.02, 10}}, p.cell_size_m);
  f(Option{"window_m", "edge of the square around the robot that is planned in, m", {2, 800}},
    p.window_m);
  f(Option{"unknown", "what no map saw is planned through never, or at unknown_price"}, p.unknown);
  f(Option{"unknown_price", "of a metre through the unknown; flat known ground costs 1", {1, 1000}},
    p.unknown_price);
  f(
      Option{
          "hard_buffer_m",
          "so far from the middle of an obstacle's cell the vehicle's middle stays, m; 0: half of "
          "the "
          "footprint's width and of a cell's diagonal",
          {0, 100}},
      p.hard_buffer_m);
  f(
      Option{
          "soft_buffer_m",
          "so much further nothing is planned, but may be driven, m (paper 5)",
          {0, 100}},
      p.soft_buffer_m);
  f(Option{"strip", "where soft buffers meet, a strip is cut free: by which rule"}, p.strip);
  f(
      Option{
          "soft_price",
          "of a metre through a soft buffer, where there is no other way out of one",
          {1, 1000}},
      p.soft_price);
  f(
      Option{
          "index_price",
          "what a traversability index of 100 adds to the price of a metre",
          {0, 1000}},
      p.index_price);
  f(Option{"slope_price", "what the vehicle's steepest slope adds", {0, 1000}}, p.slope_price);
  visitGrip(p, f);
  f(Option{"small_roughness_mps", "highest speed over small roughness, m/s", {0.05, 60}},
    p.small_roughness_mps);
  f(Option{"large_roughness_mps", "highest speed over large roughness, m/s", {0.05, 60}},
    p.large_roughness_mps);
}
}  // namespace traverse::navigation

template <>
struct traverse::options::EnumNames<traverse::navigation::UnknownPolicy>
{
  using E = traverse::navigation::UnknownPolicy;
  static constexpr std::array<std::pair<E, std::string_view>, 2> kNames = {
      {{E::never, "never"}, {E::costly, "costly"}}};
};
