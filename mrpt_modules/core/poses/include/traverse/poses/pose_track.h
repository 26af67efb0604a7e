// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace traverse::poses
{
/** Nanoseconds since 1970-01-01 UTC. */
using TimeNs = int64_t;

inline constexpr double kSecondsPerNs = 1e-9;

inline double secondsBetween(TimeNs from, TimeNs to)
{
  return static_cast<double>(to - from) * kSecondsPerNs;
}

/** So many seconds after a time, to the nearest nanosecond. */
inline TimeNs later(TimeNs time, double seconds)
{
  return time + static_cast<TimeNs>(std::llround(seconds / kSecondsPerNs));
}

/** T_map_base at a time: takes points of the vehicle frame to the map. */
struct StampedPose
{
  TimeNs time = 0;
  Eigen::Isometry3d T_map_base = Eigen::Isometry3d::Identity();
};

/** How far a pose may be trusted. */
struct TrackLimits
{
  double max_pose_age_s =
      1.0;  //!< longest gap to interpolate over, and longest reach beyond an end
  double max_speed_mps = 60.0;  //!< a faster displacement between two poses starts a new segment
  double max_turn_dps = 720.0;  //!< so does a faster turn
};

/** What building a track met. */
struct TrackReport
{
  size_t poses = 0;      //!< kept
  size_t nonfinite = 0;  //!< dropped: NaN, Inf, not a rigid motion, or beyond 1e8 m
  size_t repeated = 0;   //!< dropped: a stamp that was there already (the first is kept)
  size_t backward = 0;   //!< arrived with a stamp before its predecessor's (kept, sorted)
  size_t gaps = 0;       //!< neighbours further apart than max_pose_age_s
  size_t segments = 0;   //!< 1 + number of jumps; 0 where there is no pose
};

/** How good at() is at a time. */
enum class PoseQuality : uint8_t
{
  interpolated,  //!< between two poses of one segment, not further apart than max_pose_age_s
  extrapolated,  //!< within max_pose_age_s of one end, by the last velocity
  held,          //!< within max_pose_age_s of the only pose of a segment: no velocity is known
};

/** A pose, how it was found, and in which segment. */
struct TrackedPose
{
  Eigen::Isometry3d T_map_base = Eigen::Isometry3d::Identity();
  PoseQuality quality = PoseQuality::held;
  int segment = 0;
};

/** SE(3) poses by time. Immutable; look-up by time, never by arrival.
 *
 * Between two stamped poses the pose is interpolated on SE(3) (constant twist). Outside, and in
 * gaps, a pose is valid for max_pose_age_s, then there is none. A jump that the vehicle cannot
 * drive starts a new segment: nothing is interpolated across it. */
class PoseTrack
{
 public:
  PoseTrack() = default;

  /** Any order; see TrackReport for what is dropped. */
  explicit PoseTrack(std::vector<StampedPose> poses, const TrackLimits& limits = {});

  /** One pose for all time: a robot that stands still, or what a stock program hands over. */
  static PoseTrack constant(const Eigen::Isometry3d& T_map_base);

  std::optional<TrackedPose> at(TimeNs time) const;

  /** True where poses differ over time, so that deskewing has an effect. */
  bool moves() const { return !constant_ && poses_.size() > 1; }

  const TrackReport& report() const { return report_; }

  /** Sorted by time. */
  std::span<const StampedPose> poses() const { return poses_; }

 private:
  std::optional<TrackedPose> beyondEnd(size_t nearest, TimeNs time) const;

  /** A pose of the same segment, before or after `end`, from which to tell the velocity there. */
  std::optional<size_t> velocityNeighbour(size_t end, bool before) const;

  std::vector<StampedPose> poses_;
  std::vector<int> segment_;  // of each pose
  TrackLimits limits_;
  TrackReport report_;
  bool constant_ = false;
};

/** The rotation by an angle about a unit axis, with the same bits on every processor. */
Eigen::Matrix3d rotationBy(double angle_rad, const Eigen::Vector3d& axis);

/** The pose a fraction of the way from a to b along the constant twist between them (screw motion);
 * fraction 0 gives a, 1 gives b; outside [0, 1] the motion goes on. The same bits on every
 * processor. */
Eigen::Isometry3d interpolate(
    const Eigen::Isometry3d& a, const Eigen::Isometry3d& b, double fraction);
}  // namespace traverse::poses
