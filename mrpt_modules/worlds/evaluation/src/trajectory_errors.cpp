// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/evaluation/trajectory_errors.h>
#include <traverse/geometry/exact_trig.h>

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <limits>

namespace traverse::evaluation
{
namespace
{
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kDegPerRad = 180 / geometry::kPi;

double angleDeg(const Eigen::Matrix3d& rotation)
{
  // sine from the skew part, cosine from the trace: exact for small and for large angles
  const Eigen::Vector3d axis(
      rotation(2, 1) - rotation(1, 2), rotation(0, 2) - rotation(2, 0),
      rotation(1, 0) - rotation(0, 1));
  return geometry::angleOf(axis.norm() / 2, (rotation.trace() - 1) / 2) * kDegPerRad;
}

/** What is wrong with the found motion from one pose to another. */
Eigen::Isometry3d errorBetween(const PosePair& from, const PosePair& to)
{
  return (from.truth.inverse() * to.truth).inverse() * (from.found.inverse() * to.found);
}

double rmse(const Eigen::Matrix3Xd& off)
{
  return std::sqrt(off.colwise().squaredNorm().mean());
}

/** Metres along the true way up to each pose. */
std::vector<double> wayOf(std::span<const PosePair> pairs)
{
  std::vector<double> way_m(pairs.size(), 0);
  for (size_t i = 1; i < pairs.size(); ++i)
  {
    way_m[i] =
        way_m[i - 1] + (pairs[i].truth.translation() - pairs[i - 1].truth.translation()).norm();
  }
  return way_m;
}

RelativeError relativeError(
    std::span<const PosePair> pairs, const std::vector<double>& way_m, double distance_m)
{
  RelativeError error{distance_m, 0, kNan, kNan};
  double translation = 0;
  double rotation = 0;
  for (size_t i = 0; distance_m > 0 && i < pairs.size(); ++i)
  {
    const auto end = std::lower_bound(way_m.begin(), way_m.end(), way_m[i] + distance_m);
    if (end == way_m.end())
    {
      break;
    }
    const auto k = static_cast<size_t>(end - way_m.begin());
    const Eigen::Isometry3d off = errorBetween(pairs[i], pairs[k]);
    const double length_m = way_m[k] - way_m[i];
    translation += off.translation().norm() / length_m;
    rotation += angleDeg(off.linear()) / length_m;
    ++error.pieces;
  }
  if (error.pieces > 0)
  {
    constexpr double kPercent = 100;
    error.translation_percent = kPercent * translation / static_cast<double>(error.pieces);
    error.rotation_deg_per_m = rotation / static_cast<double>(error.pieces);
  }
  return error;
}
}  // namespace

PosePairs associate(
    const std::vector<poses::StampedPose>& found, const std::vector<poses::StampedPose>& truth)
{
  const poses::PoseTrack track(truth);
  const poses::PoseTrack sorted(found);
  PosePairs result;
  result.pairs.reserve(found.size());
  for (const poses::StampedPose& pose : sorted.poses())
  {
    const auto at = track.at(pose.time);
    if (at && at->quality == poses::PoseQuality::interpolated)
    {
      result.pairs.push_back({pose.time, pose.T_map_base, at->T_map_base});
    }
  }
  result.without_truth = found.size() - result.pairs.size();
  return result;
}

AbsoluteError absoluteError(std::span<const PosePair> pairs)
{
  if (pairs.empty())
  {
    return {kNan, kNan, kNan, kNan};
  }
  const auto n = static_cast<Eigen::Index>(pairs.size());
  Eigen::Matrix3Xd found(3, n);
  Eigen::Matrix3Xd truth(3, n);
  Eigen::Matrix3Xd from_start(3, n);
  for (Eigen::Index i = 0; i < n; ++i)
  {
    const PosePair& pair = pairs[static_cast<size_t>(i)];
    found.col(i) = pair.found.translation();
    truth.col(i) = pair.truth.translation();
    from_start.col(i) = (pairs[0].found.inverse() * pair.found).translation() -
                        (pairs[0].truth.inverse() * pair.truth).translation();
  }
  const Eigen::Isometry3d T(Eigen::umeyama(found, truth, false));
  const Eigen::Matrix3Xd off = (T * found) - truth;
  return {
      rmse(off), std::sqrt(off.colwise().squaredNorm().maxCoeff()), rmse(from_start),
      rmse(found - truth)};
}

std::vector<RelativeError> relativeErrors(
    std::span<const PosePair> pairs, const std::vector<double>& distances_m)
{
  const std::vector<double> way_m = wayOf(pairs);
  std::vector<RelativeError> errors;
  errors.reserve(distances_m.size());
  for (const double distance_m : distances_m)
  {
    errors.push_back(relativeError(pairs, way_m, distance_m));
  }
  return errors;
}

RelativeError stepError(std::span<const PosePair> pairs)
{
  const double way_m = pairs.empty() ? 0 : wayOf(pairs).back();
  if (!(way_m > 0))
  {
    return {kNan, 0, kNan, kNan};
  }
  double off_m = 0;
  double off_deg = 0;
  for (size_t i = 1; i < pairs.size(); ++i)
  {
    const Eigen::Isometry3d off = errorBetween(pairs[i - 1], pairs[i]);
    off_m += off.translation().norm();
    off_deg += angleDeg(off.linear());
  }
  constexpr double kPercent = 100;
  const size_t steps = pairs.size() - 1;
  return {way_m / static_cast<double>(steps), steps, kPercent * off_m / way_m, off_deg / way_m};
}
}  // namespace traverse::evaluation
