// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/geometry/exact_trig.h>
#include <traverse/geometry/lattice.h>
#include <traverse/poses/pose_track.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace traverse::poses
{
namespace
{
constexpr double kRotationTolerance =
    1e-6;  // R^T R against I: far above rounding, far below a real fault

bool isUsable(const Eigen::Isometry3d& T)
{
  const Eigen::Matrix3d R = T.linear();
  return T.matrix().allFinite() && T.translation().cwiseAbs().maxCoeff() <= geometry::kFarthest_m &&
         (R.transpose() * R - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() <
             kRotationTolerance &&
         R.determinant() > 0;
}

/** Angle in [0, pi] and axis of a rotation: what Eigen::AngleAxisd is, without libm. */
struct Turn
{
  double angle_rad = 0;
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();
};

Turn turnOf(const Eigen::Matrix3d& R)
{
  const Eigen::Quaterniond q(R);
  const double sine = q.vec().stableNorm();
  if (sine == 0)
  {
    return {};
  }
  const double sign = q.w() < 0 ? -1 : 1;
  return {2 * geometry::angleOf(sine, std::abs(q.w())), q.vec() / (sign * sine)};
}

/** A motion that the vehicle cannot make in the time between the two. */
bool isJump(const StampedPose& a, const StampedPose& b, const TrackLimits& limits)
{
  constexpr double kSlack_m = 0.05;  // pose noise of a robot that stands still
  constexpr double kSlackDeg = 2.0;
  const double dt = secondsBetween(a.time, b.time);
  const Eigen::Isometry3d T_a_b = a.T_map_base.inverse() * b.T_map_base;
  const double turn_deg = turnOf(T_a_b.linear()).angle_rad * 180.0 / std::numbers::pi;
  return T_a_b.translation().norm() > limits.max_speed_mps * dt + kSlack_m ||
         turn_deg > std::min(limits.max_turn_dps * dt, 180.0) + kSlackDeg;
}
}  // namespace

PoseTrack::PoseTrack(std::vector<StampedPose> poses, const TrackLimits& limits) : limits_(limits)
{
  const auto bad = std::remove_if(
      poses.begin(), poses.end(), [](const StampedPose& p) { return !isUsable(p.T_map_base); });
  report_.nonfinite = static_cast<size_t>(poses.end() - bad);
  poses.erase(bad, poses.end());
  for (size_t i = 1; i < poses.size(); ++i)
  {
    report_.backward += static_cast<size_t>(poses[i].time < poses[i - 1].time);
  }

  const auto earlier = [](const StampedPose& a, const StampedPose& b) { return a.time < b.time; };
  const auto same_time = [](const StampedPose& a, const StampedPose& b)
  { return a.time == b.time; };
  std::stable_sort(poses.begin(), poses.end(), earlier);
  const auto repeated = std::unique(poses.begin(), poses.end(), same_time);
  report_.repeated = static_cast<size_t>(poses.end() - repeated);
  poses.erase(repeated, poses.end());

  poses_ = std::move(poses);
  segment_.assign(poses_.size(), 0);
  for (size_t i = 1; i < poses_.size(); ++i)
  {
    segment_[i] = segment_[i - 1] + static_cast<int>(isJump(poses_[i - 1], poses_[i], limits_));
    report_.gaps += static_cast<size_t>(
        secondsBetween(poses_[i - 1].time, poses_[i].time) > limits_.max_pose_age_s);
  }
  report_.poses = poses_.size();
  report_.segments = poses_.empty() ? 0 : static_cast<size_t>(segment_.back()) + 1;
}

PoseTrack PoseTrack::constant(const Eigen::Isometry3d& T_map_base)
{
  PoseTrack track;
  track.poses_ = {{0, T_map_base}};
  track.segment_ = {0};
  track.report_.poses = 1;
  track.report_.segments = 1;
  track.constant_ = true;
  return track;
}

std::optional<TrackedPose> PoseTrack::at(TimeNs time) const
{
  if (poses_.empty())
  {
    return std::nullopt;
  }
  if (constant_)
  {
    return TrackedPose{poses_.front().T_map_base, PoseQuality::held, 0};
  }

  const auto after = std::lower_bound(
      poses_.begin(), poses_.end(), time,
      [](const StampedPose& p, TimeNs t) { return p.time < t; });
  const auto b = static_cast<size_t>(after - poses_.begin());
  if (b < poses_.size() && poses_[b].time == time)
  {
    return TrackedPose{poses_[b].T_map_base, PoseQuality::interpolated, segment_[b]};
  }
  if (b == 0)
  {
    return beyondEnd(0, time);
  }
  const size_t a = b - 1;
  if (b == poses_.size())
  {
    return beyondEnd(a, time);
  }
  const double gap_s = secondsBetween(poses_[a].time, poses_[b].time);
  const double from_a_s = secondsBetween(poses_[a].time, time);
  if (segment_[a] != segment_[b] || gap_s > limits_.max_pose_age_s)
  {
    return beyondEnd(from_a_s <= gap_s / 2 ? a : b, time);
  }
  return TrackedPose{
      interpolate(poses_[a].T_map_base, poses_[b].T_map_base, from_a_s / gap_s),
      PoseQuality::interpolated, segment_[a]};
}

std::optional<TrackedPose> PoseTrack::beyondEnd(size_t nearest, TimeNs time) const
{
  const StampedPose& end = poses_[nearest];
  const double away_s = secondsBetween(end.time, time);
  if (std::abs(away_s) > limits_.max_pose_age_s)
  {
    return std::nullopt;
  }
  if (const auto neighbour = velocityNeighbour(nearest, away_s > 0))
  {
    const StampedPose& other = poses_[*neighbour];
    const double fraction = 1 + away_s / secondsBetween(other.time, end.time);
    return TrackedPose{
        interpolate(other.T_map_base, end.T_map_base, fraction), PoseQuality::extrapolated,
        segment_[nearest]};
  }
  return TrackedPose{end.T_map_base, PoseQuality::held, segment_[nearest]};
}

std::optional<size_t> PoseTrack::velocityNeighbour(size_t end, bool before) const
{
  // Over less, the noise of two poses would be taken for speed.
  constexpr double kShortest_s = 0.05;
  const size_t step =
      before ? static_cast<size_t>(-1) : 1;  // unsigned: wraps below 0, and beyond the size
  for (size_t i = end + step; i < poses_.size() && segment_[i] == segment_[end]; i += step)
  {
    const double apart_s = std::abs(secondsBetween(poses_[i].time, poses_[end].time));
    if (apart_s > limits_.max_pose_age_s)
    {
      break;
    }
    if (apart_s >= kShortest_s)
    {
      return i;
    }
  }
  return std::nullopt;
}

namespace
{
/** V of the exponential map of SE(3): a motion of constant twist (v, turn) moves the origin by
 * V(turn) v. V = I + (1 - cos a)/a^2 [turn]x + (a - sin a)/a^3 [turn]x^2 with a = |turn| (Barfoot,
 * State Estimation for Robotics, 7.37). */
Eigen::Matrix3d originJacobian(const Eigen::Vector3d& turn)
{
  constexpr double kSmall = 1e-4;  // below, the series' next terms are under 1e-16
  const double a = turn.norm();
  const geometry::SinCos at = geometry::sinCosOfAny(a);
  const double first = a < kSmall ? 0.5 - a * a / 24 : (1 - at.cos) / (a * a);
  const double second = a < kSmall ? 1.0 / 6 - a * a / 120 : (a - at.sin) / (a * a * a);
  Eigen::Matrix3d cross;
  cross << 0, -turn.z(), turn.y(), turn.z(), 0, -turn.x(), -turn.y(), turn.x(), 0;
  return Eigen::Matrix3d::Identity() + first * cross + second * cross * cross;
}
}  // namespace

Eigen::Matrix3d rotationBy(double angle_rad, const Eigen::Vector3d& axis)
{
  const geometry::SinCos half = geometry::sinCosOfAny(angle_rad / 2);
  const Eigen::Vector3d v = half.sin * axis;
  return Eigen::Quaterniond(half.cos, v.x(), v.y(), v.z()).toRotationMatrix();
}

Eigen::Isometry3d interpolate(
    const Eigen::Isometry3d& a, const Eigen::Isometry3d& b, double fraction)
{
  const Eigen::Isometry3d T_a_b = a.inverse() * b;
  const Turn rotation = turnOf(T_a_b.linear());
  const Eigen::Vector3d turn = rotation.angle_rad * rotation.axis;
  const Eigen::Vector3d velocity = originJacobian(turn).inverse() * T_a_b.translation();
  Eigen::Isometry3d part = Eigen::Isometry3d::Identity();
  part.linear() = rotationBy(rotation.angle_rad * fraction, rotation.axis);
  part.translation() = originJacobian(turn * fraction) * (velocity * fraction);
  return a * part;
}
}  // namespace traverse::poses
