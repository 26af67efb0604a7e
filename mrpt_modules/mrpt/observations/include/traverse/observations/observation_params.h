// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/options/option.h>

#include <string>
#include <vector>

namespace traverse::observations
{
/** Section [Sensors]: which observations become scans, and which of their returns points. */
struct ObservationParams
{
  double min_range_m = 0.0;
  double max_range_m = 1000.0;
  std::string sensor_labels;
  std::vector<double> own_body_min_m;
  std::vector<double> own_body_max_m;
  int depth_image_step = 1;
  std::vector<double> rotating_elevations_deg;
  std::string tilting_labels;
  std::string image_folder;

  friend bool operator==(const ObservationParams&, const ObservationParams&) = default;
};

template <class P, class F>
void visitObservationParams(P& p, F&& f)
{
  using options::Option;
  f(Option{"min_range_m", "nearer returns are left out, m from the sensor", {0, 1000}},
    p.min_range_m);
  f(Option{"max_range_m", "further returns are left out, m from the sensor", {0.01, 100000}},
    p.max_range_m);
  f(Option{"sensor_labels", "labels of the sensors to use, blanks between; empty: all"},
    p.sensor_labels);
  f(
      Option{
          "own_body_min_m",
          "x y z of the lowest corner of a box of the vehicle frame whose points are left out (the "
          "vehicle's own body), m; empty: none",
          {-100, 100}},
      p.own_body_min_m);
  f(Option{"own_body_max_m", "x y z of that box's highest corner, m", {-100, 100}},
    p.own_body_max_m);
  f(Option{"depth_image_step", "takes every so-many-th pixel and row of a depth image", {1, 64}},
    p.depth_image_step);
  f(
      Option{
          "rotating_elevations_deg",
          "for CObservationRotatingScan of several rows, which carries none: elevation of each row "
          "in the order of the log, deg",
          {-90, 90}},
      p.rotating_elevations_deg);
  f(
      Option{
          "tilting_labels",
          "labels of 2-D scanners that tilt, blanks between: their rows are collected into sweeps"},
      p.tilting_labels);
  f(
      Option{
          "image_folder",
          "folder of images and clouds stored beside the log (relative: to the log); empty: as "
          "MRPT "
          "names it (<log>_Images)"},
      p.image_folder);
}

template <class F>
void visit(ObservationParams& p, F&& f)
{
  visitObservationParams(p, f);
}

template <class F>
void visit(const ObservationParams& p, F&& f)
{
  visitObservationParams(p, f);
}

/** Throws options::OptionError where members do not go together (a box of one corner, a maximum
 * below a minimum). Single members are checked by options::check(). */
void checkTogether(const ObservationParams& params);

/** True where a blank separated list has the label. */
bool hasLabel(const std::string& list, const std::string& label);
}  // namespace traverse::observations
