// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "projection.h"

#include <algorithm>
#include <cmath>

namespace traverse::traversability_grid
{
namespace
{
/** Cell and slab numbers stay below 2^30, so that sums of two fit an int32. */
constexpr double kMostCells = 1 << 30;

geometry::CellRect neighbourhoodOf(
    const Eigen::Vector3d& robot, const geometry::Lattice& lattice, double window_m)
{
  const auto side = static_cast<int32_t>(
      std::max<int64_t>(1, geometry::toMillimetres(window_m) / lattice.cell_mm));
  const geometry::CellIndex centre =
      lattice.cellOf(geometry::toMillimetres(robot.x()), geometry::toMillimetres(robot.y()));
  const geometry::CellIndex min{centre.x - side / 2, centre.y - side / 2};
  return {min, {min.x + side, min.y + side}};
}

geometry::CellRect acceptedOf(
    const geometry::CellRect& neighbourhood, const State& state, const Params& params)
{
  return params.extent == Extent::fixed
             ? geometry::intersection(neighbourhood, fixedRect(state.lattice, params))
             : neighbourhood;
}

LatticeBox boxOf(
    const Eigen::Isometry3d& T_map_base,
    const geometry::CellRect& accepted,
    const State& state,
    const Params& params)
{
  LatticeBox box;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      box.T_map_base[static_cast<size_t>(row)][static_cast<size_t>(column)] =
          T_map_base(row, column);
    }
  }
  const auto edge_mm = [&](int32_t cells)
  { return static_cast<double>(int64_t{cells} * state.lattice.cell_mm); };
  box.cell_mm = state.lattice.cell_mm;
  box.slab_mm = state.slab_mm;
  box.min_x_mm = edge_mm(accepted.min.x);
  box.min_y_mm = edge_mm(accepted.min.y);
  box.width_mm = accepted.empty() ? 0 : edge_mm(accepted.width());
  box.height_mm = accepted.empty() ? 0 : edge_mm(accepted.height());
  box.lowest_m = T_map_base.translation().z() + params.lowest_m;
  box.highest_m = T_map_base.translation().z() + params.highest_m;
  const int64_t bottom_level =
      geometry::floorDiv(geometry::toMillimetres(box.lowest_m), state.slab_mm);
  const int64_t bottom_mm = bottom_level * state.slab_mm;
  box.bottom_level = static_cast<int32_t>(bottom_level);
  box.bottom_mm = static_cast<double>(bottom_mm);
  box.depth_mm = static_cast<double>(geometry::toMillimetres(box.highest_m) + 1 - bottom_mm);
  return box;
}
}  // namespace

geometry::CellRect fixedRect(const geometry::Lattice& lattice, const Params& params)
{
  const auto low = [&](double metres)
  {
    return static_cast<int32_t>(
        geometry::floorDiv(geometry::toMillimetres(metres), lattice.cell_mm));
  };
  const auto high = [&](double metres)
  {
    return static_cast<int32_t>(
        -geometry::floorDiv(-geometry::toMillimetres(metres), lattice.cell_mm));
  };
  return {
      {low(params.fixed_min_x_m), low(params.fixed_min_y_m)},
      {high(params.fixed_max_x_m), high(params.fixed_max_y_m)}};
}

std::optional<Projection> Projection::at(
    const Eigen::Isometry3d& T_map_base, const State& state, const Params& params)
{
  const double farthest_m =
      std::min(
          geometry::kFarthest_m, kMostCells * std::min(state.lattice.cell_mm, state.slab_mm) /
                                     geometry::kMillimetresPerMetre) -
      4000;  // the widest neighbourhood and the highest point around the robot
  const Eigen::Vector3d robot = T_map_base.translation();
  const bool is_near = robot.cwiseAbs().maxCoeff() <= farthest_m;
  const Eigen::Matrix3d R = T_map_base.linear();
  const bool is_rigid =
      (R * R.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < 1e-3;
  if (!T_map_base.matrix().allFinite() || !is_near || !is_rigid)
  {
    return std::nullopt;
  }
  return Projection(T_map_base, state, params);
}

Projection::Projection(
    const Eigen::Isometry3d& T_map_base, const State& state, const Params& params) :
    neighbourhood_(neighbourhoodOf(T_map_base.translation(), state.lattice, params.window_m)),
    accepted_(acceptedOf(neighbourhood_, state, params)),
    box_(boxOf(T_map_base, accepted_, state, params))
{
}

void Projection::project(
    const points::Scan& scan, size_t first, LatticePoints& points, layers::UpdateStats& stats) const
{
  const size_t size = std::min(LatticePoints::kMost, scan.size() - first);
  toLattice(box_, &scan.x[first], &scan.y[first], &scan.z[first], size, points);
  stats.bad_points += points.bad;
  stats.outside += points.outside;
}
}  // namespace traverse::traversability_grid
