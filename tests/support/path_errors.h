// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/evaluation/trajectory_errors.h>

#include <Eigen/Geometry>

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

inline Errors errorsOf(const Path& found, const Path& reference)
{
  std::vector<evaluation::PosePair> pairs;
  pairs.reserve(found.size());
  for (size_t i = 0; i < found.size(); ++i)
  {
    pairs.push_back({0, found[i], reference[i]});
  }
  const evaluation::AbsoluteError whole = evaluation::absoluteError(pairs);
  const evaluation::RelativeError steps = evaluation::stepError(pairs);
  return {whole.from_start_m, whole.rmse_m, steps.translation_percent, steps.rotation_deg_per_m};
}
}  // namespace traverse::testing
