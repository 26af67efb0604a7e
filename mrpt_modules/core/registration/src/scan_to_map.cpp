// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "thin_out.h"

#include <traverse/points/deskew.h>
#include <traverse/registration/align.h>
#include <traverse/registration/scan_to_map.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace traverse::registration
{
namespace
{
// Lengths in voxels: the paper's values, whose voxel has 1 m.
constexpr double kFirstSigma = 2.0;
constexpr double kLeastDeviation = 0.1;
constexpr double kLeverArm = 100;
constexpr double kMapSpacing = 0.5;
constexpr double kMatchSpacing = 1.5;
constexpr double kReachInSigmas = 3.0;
constexpr double kKernelInSigmas = 1.0 / 3;

// Ours.
constexpr double kClose = 0.15;
constexpr double kSettled = 0.05;        // voxels: pairs that come and go keep steps from 0
constexpr double kWellPredicted = 0.05;  // voxels at the lever arm: deskewing again changes nothing
constexpr int kMostPasses = 2;  // more let the motion swing, as each changes the next points
constexpr int kMostFirstPasses = 5;
constexpr size_t kFewestPoints = 50;
constexpr double kLeastOverlap = 0.25;
constexpr double kLeastFirstOverlap = 0.1;  // the map is one scan, its gaps those between rings
constexpr double kLeastConstraint = 1e-3;   // see README.md

/** How far a correction moves a point at the lever arm (eq. 5): 2 r sin(angle / 2) is 2 r times the
 * vector part of the quaternion. */
double deviationOf(const Eigen::Isometry3d& T, double lever_m)
{
  return 2 * lever_m * Eigen::Quaterniond(T.linear()).vec().norm() + T.translation().norm();
}
}  // namespace

ScanToMap::ScanToMap(const Params& params) : params_(params)
{
  const bool sound = params.voxel_m >= 0 && params.max_range_m > 0 &&
                     std::isfinite(params.voxel_m) && std::isfinite(params.max_range_m);
  if (!sound)
  {
    throw std::invalid_argument("ScanToMap: a length that is none");
  }
}

Matched ScanToMap::take(points::ScanBuffer scan)
{
  if (last_.empty())
  {
    return start(std::move(scan));
  }
  Matched result = follow(scan);
  if (first_ && result.verdict != Verdict::tracked)
  {
    last_.clear();
    start(std::move(scan));  // the one before leads nowhere
  }
  return result;
}

Matched ScanToMap::follow(const points::ScanBuffer& scan)
{
  // III-A: constant velocity.
  poses::PoseTrack track = trackWith(std::nullopt);
  const auto known = track.at(scan.stamp);
  const Eigen::Isometry3d predicted = known ? known->T_map_base : last_.back().T_map_base;
  Matched result{Verdict::tracked, predicted, 0, {}};
  for (int pass = 1;; ++pass)
  {
    // III-A, B: points where the vehicle was at their times; one per voxel.
    const std::vector<Eigen::Vector3d> points = stillPoints(scan, track);
    mapFirst(track);
    // III-C, D: onto the map.
    const Eigen::Isometry3d before = result.T_map_base;
    match(points, scan.stamp, result);
    if (result.verdict != Verdict::tracked)
    {
      return result;
    }
    const bool well_predicted =
        deviation_m(before, result.T_map_base) <= kWellPredicted * voxel_m();
    if (scan.time_s.empty() || well_predicted || pass == (first_ ? kMostFirstPasses : kMostPasses))
    {
      if (first_)
      {
        result.first = last_.front();
      }
      adapt(predicted, result.T_map_base);
      keep(points, {scan.stamp, result.T_map_base});
      return result;
    }
    track = trackWith(poses::StampedPose{scan.stamp, result.T_map_base});
  }
}

Matched ScanToMap::start(points::ScanBuffer scan)
{
  const double voxel =
      params_.voxel_m > 0 ? params_.voxel_m : voxelFor(scan.view(), params_.max_range_m);
  map_.emplace(voxel);
  const std::vector<Eigen::Vector3d> points = stillPoints(scan, {});
  if (thinOut(points, kMatchSpacing * voxel).size() < kFewestPoints)
  {
    map_.reset();
    return {Verdict::too_few_points, Eigen::Isometry3d::Identity(), 0, {}};
  }
  last_.push_back({scan.stamp, Eigen::Isometry3d::Identity()});
  first_ = std::move(scan);
  return {Verdict::waiting, Eigen::Isometry3d::Identity(), 0, {}};
}

std::vector<Eigen::Vector3d> ScanToMap::stillPoints(
    points::ScanBuffer scan, const poses::PoseTrack& track) const
{
  points::deskew(scan, track);
  return thinOut(scan.view(), {kMapSpacing * voxel_m(), params_.max_range_m});
}

void ScanToMap::mapFirst(const poses::PoseTrack& track)
{
  if (first_)
  {
    map_.emplace(voxel_m());
    map_->add(stillPoints(*first_, track));
  }
}

void ScanToMap::match(
    std::span<const Eigen::Vector3d> points, points::TimeNs stamp, Matched& result)
{
  const std::vector<Eigen::Vector3d> some = thinOut(points, kMatchSpacing * voxel_m());
  if (some.size() < kFewestPoints)
  {
    result.verdict = Verdict::too_few_points;
    return;
  }
  const double sigma = sigma_m();
  // The first match has no prediction: a wide kernel.
  const Gate gate = {
      kReachInSigmas * sigma, first_ ? sigma : kKernelInSigmas * sigma, kClose * voxel_m()};
  const Alignment found = align(some, *map_, result.T_map_base, gate);
  const double overlap = static_cast<double>(found.close) / static_cast<double>(some.size());
  result.T_map_base = found.T_map_base;
  result.iterations += found.iterations;
  if (overlap < (first_ ? kLeastFirstOverlap : kLeastOverlap))
  {
    result.verdict = Verdict::little_overlap;
  }
  else if (found.constraint < kLeastConstraint)
  {
    result.verdict = Verdict::featureless;
  }
  else if (found.last_step > kSettled * voxel_m())
  {
    result.verdict = Verdict::unsettled;
  }
  else if (isJump({stamp, found.T_map_base}))
  {
    result.verdict = Verdict::jump;
  }
}

void ScanToMap::keep(const std::vector<Eigen::Vector3d>& points, const poses::StampedPose& pose)
{
  first_.reset();
  std::vector<Eigen::Vector3d> on_map;
  on_map.reserve(points.size());
  std::transform(
      points.begin(), points.end(), std::back_inserter(on_map),
      [&](const Eigen::Vector3d& p) { return pose.T_map_base * p; });
  map_->add(on_map);
  map_->forgetBeyond(pose.T_map_base.translation(), params_.max_range_m);

  const auto later = std::find_if(
      last_.begin(), last_.end(), [&](const poses::StampedPose& p) { return p.time > pose.time; });
  last_.insert(later, pose);
  const auto too_old = [&](const poses::StampedPose& p)
  { return poses::secondsBetween(p.time, last_.back().time) > params_.limits.max_pose_age_s; };
  while (too_old(last_.front()))
  {
    last_.erase(last_.begin());
  }
}

poses::PoseTrack ScanToMap::trackWith(const std::optional<poses::StampedPose>& newest) const
{
  std::vector<poses::StampedPose> some = last_;
  if (newest)
  {
    some.push_back(*newest);
  }
  return poses::PoseTrack(std::move(some), params_.limits);
}

bool ScanToMap::isJump(const poses::StampedPose& pose) const
{
  return trackWith(pose).report().segments > 1;
}

double ScanToMap::voxel_m() const
{
  return map_->voxel_m();
}

double ScanToMap::deviation_m(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) const
{
  return deviationOf(a.inverse() * b, kLeverArm * voxel_m());
}

/** Eq. 6 and 7: the standard deviation of what predictions were wrong by. */
double ScanToMap::sigma_m() const
{
  return deviations_ == 0 ? kFirstSigma * voxel_m()
                          : std::sqrt(deviation_squares_m2_ / deviations_);
}

void ScanToMap::adapt(const Eigen::Isometry3d& predicted, const Eigen::Isometry3d& found)
{
  const double off_m = deviation_m(predicted, found);
  if (!first_ && off_m > kLeastDeviation * voxel_m())
  {
    deviation_squares_m2_ += off_m * off_m;
    ++deviations_;
  }
}
}  // namespace traverse::registration
