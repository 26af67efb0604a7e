// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/ground/params.h>
#include <traverse/options/option.h>

#include <array>
#include <cstdint>
#include <string_view>
#include <utility>

namespace traverse::traversability_grid
{
/** Codes of the class layer: a contract with everybody who reads our files. */
enum class Class : uint8_t
{
  undefined = 0,
  flat = 1,
  small_roughness = 2,
  large_roughness = 3,
  obstacle = 4,
};

/** Which clouds a cell's sums are of. */
enum class Mode : uint8_t
{
  accumulated,   //!< of all so far
  single_cloud,  //!< of the last one, as in the paper
};

/** Which cells a map has. */
enum class Extent : uint8_t
{
  rolling,  //!< those of the window around the robot; what leaves it is forgotten
  fixed,    //!< those of a rectangle
  growing,  //!< all that were seen, as far as the memory budget reaches
};

/** How features become a class. */
enum class ClassifierKind : uint8_t
{
  standard,  //!< "default": against the ground and the sensor's noise too
  paper,     //!< by the cell's own features and no more
};

/** A cell is of the first class whose limits its three features do not exceed. */
struct ClassLimits
{
  double deviation_m = 0;
  double slope_deg = 0;
  double variance_m2 = 0;

  friend bool operator==(const ClassLimits&, const ClassLimits&) = default;
};

/** Section insertOpts of the map; doc/maps/traversability_grid.md says how the defaults were
 * chosen. */
struct Params
{
  double cell_size_m = 0.2;
  double slab_height_m = 0.5;
  Mode mode = Mode::accumulated;
  Extent extent = Extent::rolling;
  double window_m = 150;
  double fixed_min_x_m = -75;
  double fixed_min_y_m = -75;
  double fixed_max_x_m = 75;
  double fixed_max_y_m = 75;
  double lowest_m = -30;
  double highest_m = 30;
  int max_memory_mb = 2000;
  double forget_after_s = 0;
  int forget_after_points = 0;

  ClassifierKind classifier = ClassifierKind::standard;
  int min_points = 3;
  bool ignore_overhangs = true;
  ClassLimits flat{0.03, 30, 0.000225};
  ClassLimits small_roughness{0.10, 45, 0.0025};
  ClassLimits large_roughness{0.25, 60, 0.01};
  int index_flat = 20;
  int index_small_roughness = 45;
  int index_large_roughness = 75;
  double range_noise_m = 0.02;
  double angle_noise_deg = 0.03;
  ground::Params ground;

  friend bool operator==(const Params&, const Params&) = default;
};

template <class P, class F>
void visitExtent(P& p, F&& f)
{
  using options::Option;
  f(Option{"cell_size_m", "edge of a cell, m, to 1 mm", {0.01, 10}}, p.cell_size_m);
  f(
      Option{
          "slab_height_m",
          "height of the slabs in which a cell's sums are kept, m; never higher than the vehicle",
          {0.02, 5}},
      p.slab_height_m);
  f(Option{"mode", "sums of all clouds, or of the last one only"}, p.mode);
  f(Option{"extent", "a window that rolls with the robot, a fixed rectangle, or all that was seen"},
    p.extent);
  f(
      Option{
          "window_m",
          "edge of the square around the robot from which points are taken, and which a rolling "
          "map "
          "keeps, m",
          {1, 2000}},
      p.window_m);
  f(Option{"fixed_min_x_m", "extent = fixed: smallest x, m", {-1e6, 1e6}}, p.fixed_min_x_m);
  f(Option{"fixed_min_y_m", "extent = fixed: smallest y, m", {-1e6, 1e6}}, p.fixed_min_y_m);
  f(Option{"fixed_max_x_m", "extent = fixed: largest x, m", {-1e6, 1e6}}, p.fixed_max_x_m);
  f(Option{"fixed_max_y_m", "extent = fixed: largest y, m", {-1e6, 1e6}}, p.fixed_max_y_m);
  f(
      Option{
          "lowest_m",
          "points further below the vehicle frame's origin are left out, m",
          {-1000, 0}},
      p.lowest_m);
  f(Option{"highest_m", "points further above it are left out, m", {0, 1000}}, p.highest_m);
  f(
      Option{
          "max_memory_mb",
          "the cells take no more, MB; points that would need more are counted, not added",
          {1, 1000000}},
      p.max_memory_mb);
}

template <class P, class F>
void visitForgetting(P& p, F&& f)
{
  using options::Option;
  f(
      Option{
          "forget_after_s",
          "mode = accumulated: what was seen longer ago goes, at half of this to an eighth above "
          "it, "
          "s; 0: nothing does, as maps that are to be merged need it",
          {0, 1e7}},
      p.forget_after_s);
  f(
      Option{
          "forget_after_points",
          "mode = accumulated: a cell keeps the last half to whole of so many points; 0: all",
          {0, 2000000000}},
      p.forget_after_points);
}

template <class P, class F>
void visitClasses(P& p, F&& f)
{
  using options::Option;
  f(Option{"classifier", "how a cell's features become its class"}, p.classifier);
  f(Option{"min_points", "a cell of fewer points is undefined", {3, 1000000}}, p.min_points);
  f(
      Option{
          "ignore_overhangs",
          "a cell is read upward to the first gap that the vehicle fits under; false: all of it, "
          "as "
          "the paper does"},
      p.ignore_overhangs);
  f(Option{"flat_max_deviation_m", "flat: largest deviation from the mean height, m", {0, 100}},
    p.flat.deviation_m);
  f(Option{"flat_max_slope_deg", "flat: steepest mean plane, deg", {0, 90}}, p.flat.slope_deg);
  f(Option{"flat_max_variance_m2", "flat: largest variance of height, m^2", {0, 10000}},
    p.flat.variance_m2);
  f(Option{"small_max_deviation_m", "small roughness: the same, m", {0, 100}},
    p.small_roughness.deviation_m);
  f(Option{"small_max_slope_deg", "small roughness: the same, deg", {0, 90}},
    p.small_roughness.slope_deg);
  f(Option{"small_max_variance_m2", "small roughness: the same, m^2", {0, 10000}},
    p.small_roughness.variance_m2);
  f(Option{"large_max_deviation_m", "large roughness: the same; above is an obstacle, m", {0, 100}},
    p.large_roughness.deviation_m);
  f(Option{"large_max_slope_deg", "large roughness: the same; above is an obstacle, deg", {0, 90}},
    p.large_roughness.slope_deg);
  f(
      Option{
          "large_max_variance_m2",
          "large roughness: the same; above is an obstacle, m^2",
          {0, 10000}},
      p.large_roughness.variance_m2);
  f(Option{"index_flat", "traversability index of flat cells, 0 easiest", {0, 100}}, p.index_flat);
  f(Option{"index_small_roughness", "index of small roughness", {0, 100}}, p.index_small_roughness);
  f(Option{"index_large_roughness", "index of large roughness; an obstacle's is 100", {0, 100}},
    p.index_large_roughness);
}

template <class P, class F>
void visitNoise(P& p, F&& f)
{
  using options::Option;
  f(
      Option{
          "range_noise_m",
          "standard deviation of the sensor's ranges, m; classifier = default allows for it",
          {0, 1}},
      p.range_noise_m);
  f(
      Option{
          "angle_noise_deg",
          "standard deviation of its beams' directions and of the vehicle's attitude, deg",
          {0, 10}},
      p.angle_noise_deg);
}

template <class F>
void visit(Params& p, F&& f)
{
  visitExtent(p, f);
  visitForgetting(p, f);
  visitClasses(p, f);
  visitNoise(p, f);
  ground::visitParams(p.ground, f);
}

template <class F>
void visit(const Params& p, F&& f)
{
  visitExtent(p, f);
  visitForgetting(p, f);
  visitClasses(p, f);
  visitNoise(p, f);
  ground::visitParams(p.ground, f);
}

/** Throws OptionError where a member is out of its range or members contradict each other: limits
 * or indices that fall from class to class, a rectangle or window of no or too many cells. */
void check(const Params& params);
}  // namespace traverse::traversability_grid

template <>
struct traverse::options::EnumNames<traverse::traversability_grid::Mode>
{
  using E = traverse::traversability_grid::Mode;
  static constexpr std::array<std::pair<E, std::string_view>, 2> kNames = {
      {{E::accumulated, "accumulated"}, {E::single_cloud, "single_cloud"}}};
};

template <>
struct traverse::options::EnumNames<traverse::traversability_grid::Extent>
{
  using E = traverse::traversability_grid::Extent;
  static constexpr std::array<std::pair<E, std::string_view>, 3> kNames = {
      {{E::rolling, "rolling"}, {E::fixed, "fixed"}, {E::growing, "growing"}}};
};

template <>
struct traverse::options::EnumNames<traverse::traversability_grid::ClassifierKind>
{
  using E = traverse::traversability_grid::ClassifierKind;
  static constexpr std::array<std::pair<E, std::string_view>, 2> kNames = {
      {{E::standard, "default"}, {E::paper, "paper"}}};
};
