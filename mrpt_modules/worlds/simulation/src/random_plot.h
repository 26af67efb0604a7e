// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "strip.h"

#include <traverse/simulation/random.h>
#include <traverse/simulation/scene_params.h>

#include <utility>
#include <vector>

namespace traverse::simulation
{
/** Rounded to millimetres, so that a scene's text stays short. */
double inMillimetres(double value);

/** The middle line of a random road, places counted from its middle. */
class Way
{
 public:
  Way(Random& random, double half_m);

  /** Along these corners. */
  explicit Way(const std::pair<std::vector<double>, std::vector<double>>& corners);

  /** A place along the way, and to its left. */
  Eigen::Vector2d place(double along_m, double left_m) const;

  double yawDeg(double along_m) const;

  double distanceTo(const Eigen::Vector2d& place) const;

  /** Corners of a line beside the way, every 2 m. */
  std::pair<std::vector<double>, std::vector<double>> beside(
      double from_m, double to_m, double left_m) const;

  double half_m() const { return half_m_; }

 private:
  double half_m_;
  std::vector<Segment> line_;
};

/** A disc that is taken. */
struct Disc
{
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  double radius_m = 0;
};

/** What of a random scene's area is free. */
class Plot
{
 public:
  Plot(const SceneExtentParams& extent, const Way& way) : extent_(extent), way_(way) {}

  /** Inside of the area, at least from_way_m from the way's middle, off all that is taken. */
  bool isFree(const Disc& disc, double from_way_m) const;

  bool areFree(const std::vector<Disc>& discs, double from_way_m) const;

  void take(const Disc& disc) { taken_.push_back(disc); }

  void take(const std::vector<Disc>& discs);

 private:
  const SceneExtentParams& extent_;
  const Way& way_;
  std::vector<Disc> taken_;
};

/** Throws options::OptionError where the scene's drive does not lie within its area. */
void checkDrive(const SceneParams& scene);

/** Discs along a line of corners, close enough that nothing fits between. */
std::vector<Disc> discsAlong(
    const std::vector<double>& xs_m, const std::vector<double>& ys_m, double radius_m);
}  // namespace traverse::simulation
