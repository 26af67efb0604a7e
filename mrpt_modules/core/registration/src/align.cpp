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
/** The normal equations of one iteration, about the vehicle's place. */
struct Normal
{
  Matrix6 squares = Matrix6::Zero();  // A and b of A x = b
  Vector6 offsets = Vector6::Zero();
  size_t matched = 0;
  size_t close = 0;
  double weight = 0;
  double planes = 0;  // see Alignment
  double fitting = 0;
  double squares_m2 = 0;  // of the distances of paired points from the vehicle, weighted
};

/** What lies on no plane (posts, corners, leaves) pulls a little as points do, else a street of
 * smooth fronts leaves the way along it to few pairs. */
void addAsPoint(
    Normal& sum,
    const Surface& surface,
    const Eigen::Vector3d& at,
    const Eigen::Vector3d& arm,
    const Gate& gate)
{
  const Eigen::Vector3d d = at - surface.mean;
  const double kernel2 = gate.kernel_m * gate.kernel_m;
  const double ratio = kernel2 / (kernel2 + d.squaredNorm());
  const double weight = surface.looseness * gate.point_share * ratio * ratio;
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
    addAsPoint(sum, *surface, at, arm, gate);
    sum.weight += robust;
    sum.planes += surface->weight;
    sum.fitting += weight;
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

void move(Eigen::Isometry3d& T, const Vector6& step)
{
  const Eigen::Vector3d turn = step.tail<3>();
  const double angle = turn.norm();
  if (angle > 0)
  {
    T.linear() = poses::rotationBy(angle, turn / angle) * T.linear();
    T.linear() = Eigen::Quaterniond(T.linear()).normalized().toRotationMatrix();
  }
  T.translation() += step.head<3>();
}
}  // namespace

Vector6 stepBetween(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to)
{
  const Eigen::Quaterniond turn(to.linear() * from.linear().transpose());
  // Twice the sine of half the angle stands for the angle: 1 % off at 30 degrees.
  const Eigen::Vector3d half = turn.w() < 0 ? Eigen::Vector3d(-turn.vec()) : turn.vec();
  Vector6 step;
  step << to.translation() - from.translation(), 2 * half;
  return step;
}

Alignment align(
    std::span<const Eigen::Vector3d> points,
    LocalMap& map,
    const Eigen::Isometry3d& T_map_guess,
    const Gate& gate,
    const Prior& prior)
{
  Alignment result;
  result.T_map_base = T_map_guess;
  Eigen::Isometry3d& T = result.T_map_base;
  bool settled = false;
  while (result.iterations < gate.most_iterations && !settled)
  {
    ++result.iterations;
    const Normal normal = normalEquations(points, map, T, gate);
    result.matched = normal.matched;
    result.close = normal.close;
    result.planes = normal.planes;
    result.fit = normal.planes > 0 ? normal.fitting / normal.planes : 0;
    if (normal.matched < 6 || !(normal.weight > 0))
    {
      return result;
    }
    const Eigen::LDLT<Matrix6> solved(normal.squares + prior.information);
    const Vector6 step =
        solved.solve(normal.offsets - prior.information * stepBetween(T_map_guess, T));
    if (!step.allFinite())
    {
      return result;
    }
    move(T, step);
    result.last_step = step.norm();
    result.constraint = constraintOf(normal);
    result.information = normal.squares;
    settled = result.last_step < gate.settled;
  }
  return result;
}
}  // namespace traverse::registration
