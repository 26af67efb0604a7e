// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/multi_lidar_grid/multi_lidar_grid.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace traverse::multi_lidar_grid
{
namespace
{
constexpr double kFarthest_m = 1e7;  // so far cells have indices

bool isPose(const Eigen::Isometry3d& pose)
{
  constexpr double kRounding = 1e-6;
  const Eigen::Matrix3d R = pose.linear();
  return pose.matrix().allFinite() && pose.translation().cwiseAbs().maxCoeff() < kFarthest_m &&
         (R * R.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < kRounding;
}

geometry::CellIndex cellOf(const geometry::Lattice& lattice, const Eigen::Vector3d& p)
{
  return lattice.cellOf(geometry::toMillimetres(p.x()), geometry::toMillimetres(p.y()));
}

/** The scan's points that are neither ground nor over the vehicle, in the map frame. */
std::vector<Eigen::Vector3d> obstaclePoints(
    const State& state,
    const points::Scan& scan,
    const Eigen::Isometry3d& T_map_base,
    const Params& params,
    const geometry::Vehicle& vehicle)
{
  const double stands_on_m = T_map_base.translation().z() - vehicle.base_height_m;
  std::vector<Eigen::Vector3d> found;
  for (size_t i = 0; i < scan.size(); ++i)
  {
    const Eigen::Vector3d p = T_map_base * Eigen::Vector3d(scan.x[i], scan.y[i], scan.z[i]);
    if (!p.allFinite() || p.cwiseAbs().maxCoeff() >= kFarthest_m)
    {
      continue;
    }
    const double ground_m = state.mapper.groundAt(cellOf(state.lattice, p));
    const double up_m = p.z() - (std::isfinite(ground_m) ? ground_m : stands_on_m);
    if (up_m > params.obstacle_height_m && up_m < vehicle.height_m)
    {
      found.push_back(p);
    }
  }
  return found;
}

/** The nearest obstacle cell, searched for in squares around a point. */
class Nearest
{
 public:
  Nearest(const State& state, double reach_m) :
      state_(state),
      reach_(static_cast<int32_t>(std::min<double>(
          std::ceil(reach_m / state.lattice.cell_m()), state.cells.region().width())))
  {
  }

  /** m, squared; infinite where none is within reach. */
  double squaredDistance(const Eigen::Vector3d& p)
  {
    const geometry::CellIndex c = cellOf(state_.lattice, p);
    point_ = p;
    best_ = std::numeric_limits<double>::infinity();
    for (int32_t r = 0; r <= reach_; ++r)
    {
      const double nearest_m = (r - 1) * state_.lattice.cell_m();
      if (r > 0 && nearest_m * nearest_m >= best_)
      {
        break;
      }
      lookAtRing(c, r);
    }
    return best_;
  }

 private:
  void lookAtRing(geometry::CellIndex c, int32_t r)
  {
    for (int32_t y = -r; y <= r; ++y)
    {
      const bool is_side = y == -r || y == r;
      for (int32_t x = -r; x <= r; x += is_side || r == 0 ? 1 : 2 * r)
      {
        lookAt({c.x + x, c.y + y});
      }
    }
  }

  void lookAt(geometry::CellIndex c)
  {
    const Cell* cell = state_.cells.get(c);
    if (cell == nullptr || cell->state != layers::OccupancyState::obstacle)
    {
      return;
    }
    const double half_m = state_.lattice.cell_m() / 2;
    const double dx = std::max(0.0, std::abs(point_.x() - state_.lattice.centre_m(c.x)) - half_m);
    const double dy = std::max(0.0, std::abs(point_.y() - state_.lattice.centre_m(c.y)) - half_m);
    best_ = std::min(best_, dx * dx + dy * dy);
  }

  const State& state_;
  int32_t reach_;
  Eigen::Vector3d point_ = Eigen::Vector3d::Zero();
  double best_ = 0;
};
}  // namespace

double logLikelihood(
    const State& state,
    const points::Scan& scan,
    const Eigen::Isometry3d& T_map_base,
    const Params& params,
    const geometry::Vehicle& vehicle,
    const LikelihoodParams& likelihood)
{
  if (state.empty() || !isPose(T_map_base))
  {
    return 0;
  }
  const std::vector<Eigen::Vector3d> found =
      obstaclePoints(state, scan, T_map_base, params, vehicle);
  const size_t picked = std::min(static_cast<size_t>(likelihood.max_points), found.size());
  const double variance_m2 = likelihood.sigma_m * likelihood.sigma_m;
  Nearest nearest(state, likelihood.sigma_m * std::sqrt(2 * likelihood.worst));
  double sum = 0;
  for (size_t k = 0; k < picked; ++k)
  {
    const double squared = nearest.squaredDistance(found[k * found.size() / picked]);
    sum -= std::min(squared / (2 * variance_m2), likelihood.worst);
  }
  return sum;
}
}  // namespace traverse::multi_lidar_grid
