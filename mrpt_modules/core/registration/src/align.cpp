// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/poses/pose_track.h>
#include <traverse/registration/align.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <cmath>

namespace traverse::registration
{
namespace
{
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
constexpr int kMostIterations = 50;
constexpr double kPointShare = 0.1;
constexpr double kSmallStep = 1e-4;  // m and rad, as the paper's

/** The normal equations of one iteration, about the vehicle's place. */
struct Normal
{
  Matrix6 squares = Matrix6::Zero();  // A and b of A x = b
  Vector6 offsets = Vector6::Zero();
  size_t matched = 0;
  size_t close = 0;
  double weight = 0;
  double squares_m2 = 0;  // of the distances of paired points from the vehicle, weighted
};

/** What lies on no plane (posts, corners, leaves) pulls a little as points do, else a street of
 * smooth fronts leaves the way along it to few pairs. */
void addAsPoint(
    Normal& sum,
    const Surface& surface,
    const Eigen::Vector3d& at,
    const Eigen::Vector3d& arm,
    double kernel2)
{
  const Eigen::Vector3d d = at - surface.mean;
  const double ratio = kernel2 / (kernel2 + d.squaredNorm());
  const double weight = surface.looseness * kPointShare * ratio * ratio;
  for (int axis = 0; axis < 3 && weight > 0; ++axis)
  {
    const Eigen::Vector3d along = Eigen::Vector3d::Unit(axis);
    Vector6 slope;
    slope << along, arm.cross(along);
    sum.squares.selfadjointView<Eigen::Lower>().rankUpdate(slope, weight);
    sum.offsets -= weight * d[axis] * slope;
  }
}

Normal normalEquations(
    std::span<const Eigen::Vector3d> points,
    LocalMap& map,
    const Eigen::Isometry3d& T,
    const Gate& gate)
{
  Normal sum;
  const double kernel2 = gate.kernel_m * gate.kernel_m;
  for (const Eigen::Vector3d& p : points)
  {
    const Eigen::Vector3d arm = T.linear() * p;
    const Eigen::Vector3d at = arm + T.translation();
    const Surface* surface = map.nearest(at, gate.reach_m);
    if (surface == nullptr)
    {
      continue;
    }
    ++sum.matched;
    // The distance to the plane changes by normal . (t + w x arm).
    const double off_m = surface->normal.dot(at - surface->mean);
    const double ratio = kernel2 / (kernel2 + off_m * off_m);
    const double robust = ratio * ratio;
    const double weight = robust * surface->weight;
    Vector6 slope;
    slope << surface->normal, arm.cross(surface->normal);
    sum.squares.selfadjointView<Eigen::Lower>().rankUpdate(slope, weight);
    sum.offsets -= weight * off_m * slope;
    sum.close += static_cast<size_t>(surface->weight > 0 && std::abs(off_m) < gate.close_m);
    addAsPoint(sum, *surface, at, arm, kernel2);
    sum.weight += robust;
    sum.squares_m2 += robust * arm.squaredNorm();
  }
  const Matrix6 whole = sum.squares.selfadjointView<Eigen::Lower>();
  sum.squares = whole;
  return sum;
}

double constraintOf(const Normal& normal)
{
  const double length_m = std::sqrt(normal.squares_m2 / normal.weight);
  Vector6 scale = Vector6::Ones();
  scale.tail<3>().setConstant(1 / length_m);
  const Matrix6 scaled = scale.asDiagonal() * normal.squares * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Matrix6> solver(scaled, Eigen::EigenvaluesOnly);
  return solver.eigenvalues()(0) / normal.weight;
}
}  // namespace

Alignment align(
    std::span<const Eigen::Vector3d> points,
    LocalMap& map,
    const Eigen::Isometry3d& T_map_guess,
    const Gate& gate)
{
  Alignment result;
  result.T_map_base = T_map_guess;
  Eigen::Isometry3d& T = result.T_map_base;
  bool settled = false;
  while (result.iterations < kMostIterations && !settled)
  {
    ++result.iterations;
    const Normal normal = normalEquations(points, map, T, gate);
    result.matched = normal.matched;
    result.close = normal.close;
    if (normal.matched < 6 || !(normal.weight > 0))
    {
      return result;
    }
    const Eigen::LDLT<Matrix6> solved(normal.squares);
    const Vector6 step = solved.solve(normal.offsets);
    if (!step.allFinite())
    {
      return result;
    }
    const Eigen::Vector3d turn = step.tail<3>();
    const double angle = turn.norm();
    if (angle > 0)
    {
      T.linear() = poses::rotationBy(angle, turn / angle) * T.linear();
      T.linear() = Eigen::Quaterniond(T.linear()).normalized().toRotationMatrix();
    }
    T.translation() += step.head<3>();
    result.last_step = step.norm();
    result.constraint = constraintOf(normal);
    settled = result.last_step < kSmallStep;
  }
  return result;
}
}  // namespace traverse::registration
