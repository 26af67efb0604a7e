// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/geometry/exact_trig.h>
#include <traverse/observations/convert.h>

#include <cmath>

namespace traverse::observations
{
namespace
{
constexpr int64_t kTicks1601To1970 = 116'444'736'000'000'000;
constexpr int64_t kNsPerTick = 100;
constexpr poses::TimeNs kYear1980 = 315'532'800'000'000'000;
constexpr poses::TimeNs kYear2100 = 4'102'444'800'000'000'000;

double onGrid(double v)
{
  constexpr double kGrid = 1099511627776.0;
  return std::nearbyint(v * kGrid) / kGrid;
}
}  // namespace

Eigen::Isometry3d toIsometry(const mrpt::poses::CPose3D& pose)
{
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  const auto& R = pose.getRotationMatrix();
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      T.linear()(row, column) = onGrid(R(row, column));
    }
  }
  T.translation() = Eigen::Vector3d(pose.x(), pose.y(), pose.z());
  return T;
}

Eigen::Isometry3d toIsometry(const mrpt::poses::CPose2D& pose)
{
  const geometry::SinCos at = geometry::sinCosOfAny(pose.phi());
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear().topLeftCorner<2, 2>() << at.cos, -at.sin, at.sin, at.cos;
  T.translation() = Eigen::Vector3d(pose.x(), pose.y(), 0);
  return T;
}

mrpt::poses::CPose3D toPose3D(const Eigen::Isometry3d& motion)
{
  mrpt::math::CMatrixDouble44 matrix;
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      matrix(row, column) = motion.matrix()(row, column);
    }
  }
  return mrpt::poses::CPose3D(matrix);
}

std::optional<poses::TimeNs> toTime(const mrpt::Clock::time_point& time)
{
  const int64_t ticks = time.time_since_epoch().count();
  // Compared before multiplying: any 64 bits may come from a file.
  if (ticks < kTicks1601To1970 + kYear1980 / kNsPerTick ||
      ticks >= kTicks1601To1970 + kYear2100 / kNsPerTick)
  {
    return std::nullopt;
  }
  return (ticks - kTicks1601To1970) * kNsPerTick;
}

mrpt::Clock::time_point toTimePoint(poses::TimeNs time)
{
  return mrpt::Clock::time_point(mrpt::Clock::duration(time / kNsPerTick + kTicks1601To1970));
}
}  // namespace traverse::observations
