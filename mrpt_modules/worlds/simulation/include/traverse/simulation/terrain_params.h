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
/** What a piece of terrain is. */
enum class TerrainKind : uint8_t
{
  hills,      //!< smooth random ground
  ramp,       //!< rises along its length
  step,       //!< a higher platform
  kerb,       //!< a raised pavement
  road,       //!< a smooth strip of its own material
  ruts,       //!< two wheel grooves with steep sides
  bank,       //!< of snow: steep sides, uneven top
  ditch,      //!< a trench
  hole,       //!< a round or oblong hole
  roughness,  //!< small uneven ground
  raster,     //!< real ground from a file
};

/** Section [Terrain_NN]: one piece of ground; the pieces are added up in their order. A piece is
 * everywhere or a strip: along a line from (x_m, y_m), or along the corners xs_m, ys_m. */
struct TerrainParams
{
  TerrainKind kind = TerrainKind::hills;
  double x_m = 0;
  double y_m = 0;
  double yaw_deg = 0;
  std::vector<double> xs_m;
  std::vector<double> ys_m;
  double length_m = 0;
  double width_m = 0;
  double height_m = 0;
  double edge_m = 0;
  double groove_m = 0;
  double wavelength_m = 0;
  int seed = 0;
  MaterialChoice material = MaterialChoice::usual;
  LabelChoice label = LabelChoice::usual;
  std::string file;
  std::string transform_file;
  double origin_x_m = 0;
  double origin_y_m = 0;
  double spacing_m = 1;

  friend bool operator==(const TerrainParams&, const TerrainParams&) = default;
};

template <class P, class F>
requires std::same_as<std::remove_const_t<P>, TerrainParams>

void visit(P& p, F&& f)
{
  using options::Option;
  f(Option{"kind", "what this piece of ground is"}, p.kind);
  f(Option{"x_m", "where its line begins; hole: its middle, m", {-1e5, 1e5}}, p.x_m);
  f(Option{"y_m", "where its line begins; hole: its middle, m", {-1e5, 1e5}}, p.y_m);
  f(Option{"yaw_deg", "direction of its line, against x, deg", {-360, 360}}, p.yaw_deg);
  f(
      Option{
          "xs_m",
          "corners of a line that bends (instead of x_m, yaw_deg, length_m): x, m",
          {-1e5, 1e5}},
      p.xs_m);
  f(Option{"ys_m", "the same corners' y, m", {-1e5, 1e5}}, p.ys_m);
  f(
      Option{
          "length_m",
          "along the line, m; 0: usual (hills, step, roughness, raster: without end; hole: round)",
          {0, 1e5}},
      p.length_m);
  f(
      Option{
          "width_m",
          "across the line, m; ruts: between the middles of the grooves; 0: usual (hills, ramp, "
          "step, roughness, raster: without end)",
          {0, 1e5}},
      p.width_m);
  f(
      Option{
          "height_m",
          "height, or depth (ruts, ditch, hole), or the road's camber, or the amplitude (hills, "
          "roughness), m; 0: usual",
          {0, 100}},
      p.height_m);
  f(Option{"edge_m", "how wide its sides are, seen from above, m; 0: usual", {0, 50}}, p.edge_m);
  f(Option{"groove_m", "ruts: width of each groove, m; 0: usual", {0, 5}}, p.groove_m);
  f(
      Option{
          "wavelength_m",
          "hills, roughness, bank (its top): distance of its random heights, m; 0: usual",
          {0, 1000}},
      p.wavelength_m);
  f(Option{"seed", "hills, roughness, bank: of its random heights", {0, 2147483647}}, p.seed);
  f(Option{"material", "of its surface; usual: by kind (hills, ramp, step, ditch ...: as before)"},
    p.material);
  f(Option{"label", "of its surface; usual: by kind (hills, ramp, step, roughness: as before)"},
    p.label);
  f(
      Option{
          "file",
          "raster: NAME_ROWSxCOLS_float32.raw.gz, or a cloud of ground points (.pcd .ply .csv), "
          "relative to the ini"},
      p.file);
  f(Option{"transform_file", "raster .raw.gz: its Sim2 (R, t, s) from the world, JSON"},
    p.transform_file);
  f(Option{"origin_x_m", "raster: the file's x at the scene's zero, m", {-1e8, 1e8}}, p.origin_x_m);
  f(Option{"origin_y_m", "raster: the file's y at the scene's zero, m", {-1e8, 1e8}}, p.origin_y_m);
  f(Option{"spacing_m", "raster of points: distance of the grid's nodes, m", {0.05, 100}},
    p.spacing_m);
}
}  // namespace traverse::simulation

template <>
struct traverse::options::EnumNames<traverse::simulation::TerrainKind>
{
  using E = traverse::simulation::TerrainKind;
  static constexpr std::array<std::pair<E, std::string_view>, 11> kNames = {
      {{E::hills, "hills"},
       {E::ramp, "ramp"},
       {E::step, "step"},
       {E::kerb, "kerb"},
       {E::road, "road"},
       {E::ruts, "ruts"},
       {E::bank, "bank"},
       {E::ditch, "ditch"},
       {E::hole, "hole"},
       {E::roughness, "roughness"},
       {E::raster, "raster"}}};
};
