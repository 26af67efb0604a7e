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

namespace traverse::simulation
{
/** Kinds of random scenes. */
enum class RandomStyle : uint8_t
{
  none,       //!< nothing is added
  paper_3,    //!< a road through rolling fields in winter or spring
  paper_5,    //!< a winding street between walls, cars and people
  clutter,    //!< for navigators: boxes, cylinders and walls anyhow
  park,       //!< for navigators: a path over hills, ditches with crossings, trees
  tunnel,     //!< for navigators: a bent corridor between two open grounds
  warehouse,  //!< for navigators: aisles between racks, people who walk in them
  icy_lot,    //!< for navigators: a parking lot with patches of ice
};

/** Section [Random]: what generate() adds. Numbers of things are means: a seed has between a half
 * and one and a half times as many (clutter: as many, where they find room). */
struct RandomSceneParams
{
  RandomStyle style = RandomStyle::none;
  double drive_m = 40;
  double hill_height_m = 0.8;
  double roughness_m = 0.008;
  double bank_share = 0.5;
  double kerb_chance = 0.35;
  double ditch_chance = 0.4;
  int ruts = 3;
  int lump_fields = 6;
  int grass_patches = 4;
  int trees = 9;
  int bushes = 6;
  int poles = 4;
  int walls = 2;
  int fences = 3;
  int buildings = 1;
  int parked_vehicles = 2;
  int moving_vehicles = 1;
  int people = 3;
  int things = 3;
  int holes = 2;
  int overhangs = 2;
  double corridor_m = 2.5;
  double slope_deg = 12;
  int ditches = 3;
  int ice_patches = 8;

  friend bool operator==(const RandomSceneParams&, const RandomSceneParams&) = default;
};

template <class P, class F>
requires std::same_as<std::remove_const_t<P>, RandomSceneParams>

void visit(P& p, F&& f)
{
  using options::Option;
  f(Option{"style", "kind of the random scene; none: nothing is added"}, p.style);
  f(Option{"drive_m", "length of the vehicle's way, m", {5, 500}}, p.drive_m);
  f(Option{"hill_height_m", "largest amplitude of the hills, m", {0, 3}}, p.hill_height_m);
  f(Option{"roughness_m", "amplitude of the field's fine roughness, m", {0, 0.015}}, p.roughness_m);
  f(Option{"bank_share", "share of the roadside with snow banks", {0, 1}}, p.bank_share);
  f(Option{"kerb_chance", "probability of a pavement with a kerb", {0, 1}}, p.kerb_chance);
  f(Option{"ditch_chance", "probability of a ditch along the road", {0, 1}}, p.ditch_chance);
  f(Option{"ruts", "pairs of ruts", {0, 20}}, p.ruts);
  f(Option{"lump_fields", "fields of clods", {0, 40}}, p.lump_fields);
  f(Option{"grass_patches", "patches of grass", {0, 40}}, p.grass_patches);
  f(Option{"trees", "trees", {0, 100}}, p.trees);
  f(Option{"bushes", "bushes", {0, 100}}, p.bushes);
  f(Option{"poles", "poles", {0, 100}}, p.poles);
  f(Option{"walls", "walls", {0, 20}}, p.walls);
  f(Option{"fences", "fences of wire or boards", {0, 20}}, p.fences);
  f(Option{"buildings", "buildings", {0, 20}}, p.buildings);
  f(Option{"parked_vehicles", "parked cars", {0, 100}}, p.parked_vehicles);
  f(Option{"moving_vehicles", "cars that drive", {0, 4}}, p.moving_vehicles);
  f(Option{"people", "people, most of them walking", {0, 50}}, p.people);
  f(Option{"things", "boxes, drums and round stones", {0, 100}}, p.things);
  f(Option{"holes", "paper_5: holes at the roadside", {0, 20}}, p.holes);
  f(
      Option{
          "overhangs",
          "paper_5: bridges and beams over the road; tunnel: 0: none has a roof",
          {0, 10}},
      p.overhangs);
  f(Option{"corridor_m", "tunnel: its width, 0.3 m more or less by seed, m", {2, 6}}, p.corridor_m);
  f(Option{"slope_deg", "park: the steepest slope of its hills, deg", {0, 30}}, p.slope_deg);
  f(Option{"ditches", "park: ditches across the path, with crossings", {0, 10}}, p.ditches);
  f(Option{"ice_patches", "icy_lot: patches of ice", {0, 100}}, p.ice_patches);
}
}  // namespace traverse::simulation

template <>
struct traverse::options::EnumNames<traverse::simulation::RandomStyle>
{
  using E = traverse::simulation::RandomStyle;
  static constexpr std::array<std::pair<E, std::string_view>, 8> kNames = {
      {{E::none, "none"},
       {E::paper_3, "paper_3"},
       {E::paper_5, "paper_5"},
       {E::clutter, "clutter"},
       {E::park, "park"},
       {E::tunnel, "tunnel"},
       {E::warehouse, "warehouse"},
       {E::icy_lot, "icy_lot"}}};
};
