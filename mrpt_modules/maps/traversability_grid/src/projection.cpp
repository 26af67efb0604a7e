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
             ? Cells::intersection(neighbourhood, fixedRect(state.lattice, params))
             : neighbourhood;
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
    T_map_base_(T_map_base),
    neighbourhood_(neighbourhoodOf(T_map_base.translation(), state.lattice, params.window_m)),
    accepted_(acceptedOf(neighbourhood_, state, params)),
    by_cell_(state.lattice.cell_mm),
    by_slab_(state.slab_mm),
    lowest_m_(T_map_base.translation().z() + params.lowest_m),
    highest_m_(T_map_base.translation().z() + params.highest_m)
{
}

void Projection::project(
    const points::Scan& scan,
    std::vector<LatticePoint>& projected,
    layers::UpdateStats& stats) const
{
  projected.clear();
  projected.reserve(scan.size());
  for (size_t i = 0; i < scan.size(); ++i)
  {
    if (const auto point = project({scan.x[i], scan.y[i], scan.z[i]}, stats))
    {
      projected.push_back(*point);
    }
  }
}

std::optional<LatticePoint> Projection::project(
    const Eigen::Vector3f& p_base, layers::UpdateStats& stats) const
{
  const Eigen::Vector3d p = T_map_base_ * p_base.cast<double>();
  // Written so that NaN fails it.
  const bool is_usable = std::abs(p.x()) <= geometry::kFarthest_m &&
                         std::abs(p.y()) <= geometry::kFarthest_m &&
                         std::abs(p.z()) <= geometry::kFarthest_m;
  if (!is_usable)
  {
    ++stats.bad_points;
    return std::nullopt;
  }
  const geometry::FloorQuotient x = by_cell_(geometry::toMillimetres(p.x()));
  const geometry::FloorQuotient y = by_cell_(geometry::toMillimetres(p.y()));
  const bool is_inside = x.quotient >= accepted_.min.x && x.quotient < accepted_.max.x &&
                         y.quotient >= accepted_.min.y && y.quotient < accepted_.max.y &&
                         p.z() >= lowest_m_ && p.z() <= highest_m_;
  if (!is_inside)
  {
    ++stats.outside;
    return std::nullopt;
  }
  const geometry::FloorQuotient z = by_slab_(geometry::toMillimetres(p.z()));
  return LatticePoint{
      {static_cast<int32_t>(x.quotient), static_cast<int32_t>(y.quotient)},
      static_cast<int32_t>(z.quotient),
      {static_cast<uint16_t>(x.remainder), static_cast<uint16_t>(y.remainder),
       static_cast<uint16_t>(z.remainder)}};
}
}  // namespace traverse::traversability_grid
