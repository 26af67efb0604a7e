// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <numbers>
#include <sstream>
#include <string>
#include <support/labelled_clouds.h>
#include <vector>

namespace traverse::testing
{
using Path = std::vector<Eigen::Isometry3d>;
inline constexpr double kDegPerRad = 180 / std::numbers::pi;

/** Rows of 3x4 behind `skip` words. */
inline Path readRows(const std::filesystem::path& file, int skip)
{
  const std::vector<char> bytes = unpacked(file);
  std::istringstream text(std::string(bytes.begin(), bytes.end()));
  Path path;
  std::string word;
  while (text >> word)
  {
    for (int i = 1; i < skip; ++i)
    {
      text >> word;
    }
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    for (int i = 0; i < 12; ++i)
    {
      text >> T.matrix()(i / 4, i % 4);
    }
    T.linear() = Eigen::Quaterniond(T.linear()).normalized().toRotationMatrix();
    path.push_back(T);
  }
  return path;
}

/** The errors of a path against a reference of as many poses. */
struct Errors
{
  double ate_m = 0;          //!< root mean square, first poses laid together
  double ate_aligned_m = 0;  //!< the same after the best rigid motion (Umeyama, no scale)
  double step_percent = 0;   //!< mean error of a step's translation, of the mean step
  double step_deg_per_m = 0;
};

inline double rmse(const Eigen::Matrix3Xd& difference)
{
  return std::sqrt(difference.colwise().squaredNorm().mean());
}

inline Errors errorsOf(const Path& found, const Path& reference)
{
  const auto n = static_cast<Eigen::Index>(found.size());
  Eigen::Matrix3Xd a(3, n);
  Eigen::Matrix3Xd b(3, n);
  double way_m = 0;
  double off_m = 0;
  double off_deg = 0;
  for (Eigen::Index i = 0; i < n; ++i)
  {
    const auto k = static_cast<size_t>(i);
    a.col(i) = (found[0].inverse() * found[k]).translation();
    b.col(i) = (reference[0].inverse() * reference[k]).translation();
    if (k > 0)
    {
      const Eigen::Isometry3d step = reference[k - 1].inverse() * reference[k];
      const Eigen::Isometry3d off = step.inverse() * (found[k - 1].inverse() * found[k]);
      way_m += step.translation().norm();
      off_m += off.translation().norm();
      off_deg += Eigen::AngleAxisd(off.linear()).angle() * kDegPerRad;
    }
  }
  const Eigen::Isometry3d T(Eigen::umeyama(a, b, false));
  return {rmse(a - b), rmse((T * a) - b), 100 * off_m / way_m, off_deg / way_m};
}

}  // namespace traverse::testing
