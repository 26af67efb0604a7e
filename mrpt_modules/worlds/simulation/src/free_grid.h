// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/simulation/scene_params.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace traverse::simulation
{
/** A rectangle turned anyhow, with rounded corners: where a thing stands. */
struct Stand
{
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  Eigen::Vector2d axis = Eigen::Vector2d::UnitX();  //!< of length 1
  double half_x_m = 0;                              //!< along the axis
  double half_y_m = 0;
  double round_m = 0;  //!< that much further on all sides

  /** Of a place from it; 0 inside. */
  double distanceTo(const Eigen::Vector2d& place) const;

  /** Half of its longest diagonal. */
  double reach_m() const;
};

Stand discAt(const Eigen::Vector2d& middle, double radius_m);

/** Along a straight line, so wide on either side. */
Stand lineBetween(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double half_m);

/** Where the middle of a vehicle can be, in cells of kCell_m: places at least `margin_m` from all
 * stands. What is outside of the area is not free. */
class FreeGrid
{
 public:
  static constexpr double kCell_m = 0.2;

  FreeGrid(const SceneExtentParams& area, double margin_m);

  /** Cells of which a place is nearer than the margin are blocked. */
  void block(const Stand& stand);

  /** A shortest way over free cells, eight neighbours each; empty where there is none. */
  std::vector<Eigen::Vector2d> way(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;

  bool isFree(const Eigen::Vector2d& place) const;

 private:
  int columnOf(double x_m) const;
  int rowOf(double y_m) const;
  Eigen::Vector2d middleOf(int cell) const;
  int cellOf(const Eigen::Vector2d& place) const;  //!< -1: outside
  std::vector<int> waveFrom(int from, int to) const;

  SceneExtentParams area_;
  double margin_m_;
  int columns_;
  int rows_;
  std::vector<uint8_t> blocked_;
};
}  // namespace traverse::simulation
