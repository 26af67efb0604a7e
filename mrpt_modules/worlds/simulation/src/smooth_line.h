// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <vector>

namespace traverse::simulation
{
/** A natural cubic spline through points, walked by the way along it. */
class SmoothLine
{
 public:
  static constexpr double kLongestStepMetres = 0.05;

  struct Place
  {
    Eigen::Vector2d p = Eigen::Vector2d::Zero();
    Eigen::Vector2d heading = Eigen::Vector2d::UnitX();  //!< of length 1
  };

  /** Throws std::invalid_argument, see driveOn(). One point alone is a line of length 0 that heads
   * along x. */
  SmoothLine(const std::vector<double>& xs_m, const std::vector<double>& ys_m);

  double lengthMetres() const { return length_m_; }

  /** In even steps from the beginning to the end. */
  const std::vector<Place>& places() const { return places_; }

  /** Where on places() a way from the beginning ends: an index, with its fraction. */
  double indexAt(double s_m) const;

  Place at(double s_m) const;

 private:
  double length_m_ = 0;
  double step_m_ = kLongestStepMetres;
  std::vector<Place> places_;
};
}  // namespace traverse::simulation
