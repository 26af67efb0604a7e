// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/simulation/scene_choices.h>

#include <concepts>
#include <string>
#include <type_traits>
#include <vector>

namespace traverse::simulation
{
/** What an object is. */
enum class ObjectKind : uint8_t
{
  box,
  prism,
  cylinder,
  hemisphere,
  wall,
  building,
  fence_wire,
  fence_board,
  grass,
  lumps,
  bush,
  tree,
  pole,
  vehicle,
  person,
  bridge,
  gate,
  table,
};

/** Section [Object_NN]: one thing on the ground. Its frame: x along yaw_deg, origin in its middle
 * (wall, fences: at its beginning) at the height of the ground there. Sizes of 0 are the kind's
 * usual ones. */
struct ObjectParams
{
  ObjectKind kind = ObjectKind::box;
  double x_m = 0;
  double y_m = 0;
  double z_m = 0;
  double yaw_deg = 0;
  double length_m = 0;
  double width_m = 0;
  double height_m = 0;
  double radius_m = 0;
  double branch_height_m = 0;
  double branch_m = 0;
  int count = 0;
  int seed = 0;
  MaterialChoice material = MaterialChoice::usual;
  LabelChoice label = LabelChoice::usual;
  std::vector<double> xs_m;
  std::vector<double> ys_m;
  std::vector<double> track_xs_m;
  std::vector<double> track_ys_m;
  double speed_mps = 1;
  double start_s = 0;

  friend bool operator==(const ObjectParams&, const ObjectParams&) = default;
};

template <class P, class F>
requires std::same_as<std::remove_const_t<P>, ObjectParams>

void visit(P& p, F&& f)
{
  using options::Option;
  f(Option{"kind", "what it is"}, p.kind);
  f(Option{"x_m", "where it stands, m", {-1e5, 1e5}}, p.x_m);
  f(Option{"y_m", "where it stands, m", {-1e5, 1e5}}, p.y_m);
  f(Option{"z_m", "of its foot above the ground, m", {-100, 1000}}, p.z_m);
  f(Option{"yaw_deg", "of its x axis against the map's, deg", {-360, 360}}, p.yaw_deg);
  f(Option{"length_m", "along its x, m; 0: usual", {0, 2000}}, p.length_m);
  f(Option{"width_m", "along its y, m; tree, bush: across the crown; 0: usual", {0, 2000}},
    p.width_m);
  f(Option{"height_m", "m; bridge, gate: free height under it; 0: usual", {0, 200}}, p.height_m);
  f(
      Option{
          "radius_m",
          "of cylinder, hemisphere, pole, trunk; lumps: the largest, m; 0: usual",
          {0, 100}},
      p.radius_m);
  f(Option{"branch_height_m", "tree: of its lowest leaves above the ground, m; 0: usual", {0, 100}},
    p.branch_height_m);
  f(
      Option{
          "branch_m",
          "tree: reach of a long branch along its x at branch_height_m, m; 0: none",
          {0, 50}},
      p.branch_m);
  f(
      Option{
          "count",
          "lumps: how many; grass: blades on a square metre; bush, tree: leaves; 0: usual",
          {0, 200000}},
      p.count);
  f(Option{"seed", "of what is random in it", {0, 2147483647}}, p.seed);
  f(Option{"material", "of its main part; usual: by kind"}, p.material);
  f(Option{"label", "in the truth; usual: by kind"}, p.label);
  f(
      Option{
          "xs_m",
          "prism: outline, wall and fences: corners that they follow; x in its frame, m",
          {-2000, 2000}},
      p.xs_m);
  f(Option{"ys_m", "the same corners' y, m", {-2000, 2000}}, p.ys_m);
  f(
      Option{
          "track_xs_m",
          "vehicle, person: corners of its way (instead of x_m, yaw_deg): x, m",
          {-1e5, 1e5}},
      p.track_xs_m);
  f(Option{"track_ys_m", "the same corners' y, m", {-1e5, 1e5}}, p.track_ys_m);
  f(Option{"speed_mps", "on its track, m/s", {0.01, 100}}, p.speed_mps);
  f(Option{"start_s", "when it starts, s after the scene's beginning", {0, 1e5}}, p.start_s);
}
}  // namespace traverse::simulation

template <>
struct traverse::options::EnumNames<traverse::simulation::ObjectKind>
{
  using E = traverse::simulation::ObjectKind;
  static constexpr std::array<std::pair<E, std::string_view>, 18> kNames = {
      {{E::box, "box"},
       {E::prism, "prism"},
       {E::cylinder, "cylinder"},
       {E::hemisphere, "hemisphere"},
       {E::wall, "wall"},
       {E::building, "building"},
       {E::fence_wire, "fence_wire"},
       {E::fence_board, "fence_board"},
       {E::grass, "grass"},
       {E::lumps, "lumps"},
       {E::bush, "bush"},
       {E::tree, "tree"},
       {E::pole, "pole"},
       {E::vehicle, "vehicle"},
       {E::person, "person"},
       {E::bridge, "bridge"},
       {E::gate, "gate"},
       {E::table, "table"}}};
};
