// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "thin_out.h"

#include <traverse/geometry/exact_trig.h>
#include <traverse/points/deskew.h>
#include <traverse/registration/odometry_to_map.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

namespace traverse::registration
{
namespace
{
constexpr double kRadPerDegree = geometry::kPi / 180;

// In voxels.
constexpr double kMapSpacing = 0.3;
constexpr double kMatchSpacing = 1.0;
constexpr double kReach = 1.0;

// What is taken for the standard deviation of one pair's distance, m. Noise is 1 to 3 cm; but pairs
// share the errors of their planes, so they tell less than so many measurements would.
constexpr double kPair = 0.1;
constexpr double kKernel = 0.25;  // m: pairs that far off still tell that the wheels slipped

constexpr size_t kFewestPoints = 50;
constexpr size_t kMostPairs = 1000;
constexpr double kLeastMatched = 0.25;  // of the points: new ground comes into view
constexpr double kFewestPlanes = 6;     // as many as directions of motion
constexpr double kLeastFit = 0.5;
constexpr double kSettled = 1e-3;  // m and rad
constexpr double kUnsettled = 0.05;
constexpr int kMostIterations = 12;

// The squared Mahalanobis distance of pairs from prediction seldom passes 1, as kPair is large;
// wheels that spin at 1 m/s reach 2 within a few scans. Beyond the most it is another place.
constexpr double kSurprise = 2;
constexpr double kMostSurprise = 1000;

// Key frames of a lidar lie so far apart, m, or are turned so far, deg.
constexpr double kKeyFrameWay = 0.4;
constexpr double kKeyFrameTurn = 15;

// A vehicle that stands may be pushed or loaded: variances of a second, m2 and rad2.
constexpr double kStandingPlace = 1e-6;
constexpr double kStandingTurn = 1e-6;

Eigen::Matrix3d crossOf(const Eigen::Vector3d& v)
{
  Eigen::Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

Matrix6 inverseOf(const Matrix6& symmetric)
{
  return symmetric.ldlt().solve(Matrix6::Identity());
}

/** The larger of the two horizontal standard deviations along the ellipse's axes, m. */
double horizontalDeviation_m(const Matrix6& covariance)
{
  const double mean = (covariance(0, 0) + covariance(1, 1)) / 2;
  const double half = (covariance(0, 0) - covariance(1, 1)) / 2;
  return std::sqrt(mean + std::sqrt(half * half + covariance(0, 1) * covariance(0, 1)));
}

/** Whether one is a key frame beside the other. */
bool isApart(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b)
{
  const Eigen::Isometry3d between = a.inverse() * b;
  const double cosine = (between.linear().trace() - 1) / 2;  // of the turn
  return between.translation().norm() > kKeyFrameWay ||
         cosine < geometry::sinCosOf(kKeyFrameTurn * kRadPerDegree).cos;
}

/** One point per voxel of the raw cloud; then fewer are to be deskewed. */
points::ScanBuffer thinned(const points::ScanBuffer& scan, const Thinning& thinning)
{
  points::ScanBuffer some;
  some.stamp = scan.stamp;
  some.T_base_sensor = scan.T_base_sensor;
  for (const size_t i : thinOutIndices(scan.view(), thinning))
  {
    some.x.push_back(scan.x[i]);
    some.y.push_back(scan.y[i]);
    some.z.push_back(scan.z[i]);
    if (!scan.time_s.empty())
    {
      some.time_s.push_back(scan.time_s[i]);
    }
  }
  return some;
}

std::vector<Eigen::Vector3d> pointsOf(const points::ScanBuffer& scan)
{
  std::vector<Eigen::Vector3d> points;
  points.reserve(scan.size());
  for (size_t i = 0; i < scan.size(); ++i)
  {
    points.emplace_back(scan.x[i], scan.y[i], scan.z[i]);
  }
  return points;
}

/** At most so many, evenly taken. */
std::vector<Eigen::Vector3d> atMost(const std::vector<Eigen::Vector3d>& points, size_t most)
{
  if (points.size() <= most)
  {
    return points;
  }
  std::vector<Eigen::Vector3d> some;
  some.reserve(most);
  for (size_t i = 0; i < most; ++i)
  {
    some.push_back(points[i * points.size() / most]);
  }
  return some;
}

Fit judged(const Alignment& found, size_t points)
{
  const bool lies_on_map =
      static_cast<double>(found.matched) >= kLeastMatched * static_cast<double>(points) &&
      found.planes >= kFewestPlanes && found.fit >= kLeastFit;
  if (!lies_on_map)
  {
    return Fit::little_overlap;
  }
  return found.last_step > kUnsettled ? Fit::unsettled : Fit::matched;
}
}  // namespace

OdometryToMap::OdometryToMap(const FollowParams& params, const Eigen::Isometry3d& T_map_odom) :
    params_(params), map_(params.voxel_m), T_map_odom_(T_map_odom)
{
  for (const double each :
       {params.max_range_m, params.along_m, params.aside_m, params.up_m, params.yaw_deg,
        params.tilt_deg, params.turn_share, params.carried_m, params.max_deviation_m})
  {
    if (!std::isfinite(each) || each <= 0)
    {
      throw std::invalid_argument("OdometryToMap: a parameter that is not positive");
    }
  }
}

Followed OdometryToMap::take(const points::ScanBuffer& scan, const poses::PoseTrack& odometry)
{
  const auto at = odometry.at(scan.stamp);
  if (!at)
  {
    return {Fit::no_odometry, T_map_odom_ * T_odom_last_, 0, horizontalDeviation_m(covariance_)};
  }
  points::ScanBuffer some = thinned(scan, {kMapSpacing * params_.voxel_m, params_.max_range_m});
  points::deskew(some, odometry);
  const std::vector<Eigen::Vector3d> points = pointsOf(some);

  predict(at->T_map_base, scan.stamp);
  Followed result = follow(points, scan.sensor_label, T_map_odom_ * at->T_map_base);
  T_map_odom_ = result.T_map_base * at->T_map_base.inverse();
  result.deviation_m = horizontalDeviation_m(covariance_);
  if (carried_m_ <= params_.carried_m && result.deviation_m <= params_.max_deviation_m)
  {
    relied_on_ = std::max(relied_on_.value_or(scan.stamp), scan.stamp);
  }
  return result;
}

/** What is known of the pose at a scan's time before that scan. */
void OdometryToMap::predict(const Eigen::Isometry3d& T_odom_base, poses::TimeNs stamp)
{
  if (!began_)
  {
    T_odom_last_ = T_odom_base;
    last_ = stamp;
    return;
  }
  const Eigen::Isometry3d moved = T_odom_last_.inverse() * T_odom_base;
  const Eigen::Matrix3d R_map_base = (T_map_odom_ * T_odom_last_).linear();
  Matrix6 onward = Matrix6::Identity();
  onward.topRightCorner<3, 3>() = -crossOf(R_map_base * moved.translation());

  const double way_m = moved.translation().norm();
  const double turn_rad = 2 * Eigen::Quaterniond(moved.linear()).vec().norm();
  const double passed_s = std::abs(poses::secondsBetween(last_, stamp));
  const auto squared = [](double v) { return v * v; };
  const double tilt = squared(params_.tilt_deg * kRadPerDegree);
  const double yaw = squared(params_.yaw_deg * kRadPerDegree);
  Vector6 variance;
  variance << squared(params_.along_m), squared(params_.aside_m), squared(params_.up_m), tilt, tilt,
      yaw;
  variance *= way_m;
  variance[5] += squared(params_.turn_share) * turn_rad;
  variance.head<3>().array() += kStandingPlace * passed_s;
  variance.tail<3>().array() += kStandingTurn * passed_s;
  Matrix6 turned = Matrix6::Zero();
  turned.topLeftCorner<3, 3>() =
      R_map_base * variance.head<3>().asDiagonal() * R_map_base.transpose();
  turned.bottomRightCorner<3, 3>() =
      R_map_base * variance.tail<3>().asDiagonal() * R_map_base.transpose();
  covariance_ = onward * covariance_ * onward.transpose() + turned;
  carried_m_ += way_m;
  T_odom_last_ = T_odom_base;
  last_ = stamp;
}

Followed OdometryToMap::follow(
    const std::vector<Eigen::Vector3d>& points,
    const std::string& label,
    const Eigen::Isometry3d& predicted)
{
  const std::vector<Eigen::Vector3d> some =
      atMost(thinOut(points, kMatchSpacing * params_.voxel_m), kMostPairs);
  if (some.size() < kFewestPoints)
  {
    return {Fit::too_few_points, predicted, 0, 0};
  }
  // Lidars may look at places that have nothing in common.
  if (!key_frames_.contains(label) && (!began_ || carried_m_ <= kKeyFrameWay))
  {
    began_ = true;
    keep(points, label, predicted);
    return {Fit::began, predicted, 0, 0};
  }
  Estimate now = estimate(some, predicted, covariance_);
  int iterations = now.found.iterations;
  const double surprise = now.surprise;
  if (surprise > kSurprise && surprise <= kMostSurprise)
  {
    now = estimate(some, predicted, surprise / kSurprise * covariance_);
    iterations += now.found.iterations;
  }
  const Fit fit = surprise > kMostSurprise ? Fit::contradicts : judged(now.found, some.size());
  if (fit != Fit::matched)
  {
    return {fit, predicted, iterations, 0};
  }
  covariance_ = now.covariance;
  carried_m_ = 0;
  keep(points, label, now.found.T_map_base);
  return {fit, now.found.T_map_base, iterations, 0};
}

OdometryToMap::Estimate OdometryToMap::estimate(
    const std::vector<Eigen::Vector3d>& points,
    const Eigen::Isometry3d& predicted,
    const Matrix6& covariance)
{
  constexpr double kPairSquared = kPair * kPair;
  // Never quite singular: a vehicle that has not moved since it was placed.
  const Matrix6 before = covariance + 1e-8 * Matrix6::Identity();
  const Prior prior{kPairSquared * inverseOf(before)};
  const Gate gate = {kReach * params_.voxel_m, kKernel, kKernel, 0, kSettled, kMostIterations};
  Estimate result;
  result.found = align(points, map_, predicted, gate, prior);
  const Matrix6 both = result.found.information + prior.information;
  result.covariance = kPairSquared * inverseOf(both);

  // e' (R + P)^-1 e with P `before`, R the pairs' covariance: at the minimum prior and pairs pull
  // alike, v = P^-1 d = R^-1 (e - d), so e = (P + R) v. What only the prior holds adds nothing.
  constexpr double kOpen = 1e-3;
  const Vector6 d = stepBetween(predicted, result.found.T_map_base);
  const Vector6 v = prior.information * d / kPairSquared;
  const Matrix6 pairs = (result.found.information + kOpen * prior.information) / kPairSquared;
  result.surprise = v.dot(before * v + inverseOf(pairs) * v);
  return result;
}

void OdometryToMap::keep(
    const std::vector<Eigen::Vector3d>& points,
    const std::string& label,
    const Eigen::Isometry3d& T_map_base)
{
  const auto [last, is_first] = key_frames_.try_emplace(label, T_map_base);
  if (!is_first && !isApart(last->second, T_map_base))
  {
    return;
  }
  last->second = T_map_base;
  std::vector<Eigen::Vector3d> on_map;
  on_map.reserve(points.size());
  std::transform(
      points.begin(), points.end(), std::back_inserter(on_map),
      [&](const Eigen::Vector3d& p) { return T_map_base * p; });
  map_.add(on_map);
  map_.forgetBeyond(T_map_base.translation(), params_.max_range_m);
}
}  // namespace traverse::registration
