// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/points/scan.h>
#include <traverse/poses/pose_track.h>

#include <Eigen/Geometry>

#include <optional>
#include <vector>

namespace traverse::diagnosis
{
/** Upright things (no ground) that one scan saw, thinned. */
struct Sighted
{
  poses::TimeNs stamp = 0;
  std::vector<Eigen::Vector3f> p_base;  //!< before deskewing, vehicle frame of the point's own time
  std::vector<float> time_s;            //!< relative to stamp; of the same length, or empty
};

/** The points of a scan that stand at least `above_m` above the plane up . p = offset_m (of no
 * plane: all), 2 to 40 m from the sensor, at most 600. */
Sighted sightedBy(
    const points::Scan& scan, const Eigen::Vector3d& up, double offset_m, double above_m = 0.4);

/** A value that makes the scans of a drive lie on each other best. */
struct BestFit
{
  double value = 0;

  /** How much more of the map is filled at 0 than at the best value, e.g. 0.10: how much is won. */
  double gain = 0;

  /** How much more is filled at the worst value tried than at the best: what the drive can tell. A
   * straight drive at one speed tells nothing of time, a robot that only turns nothing of heading.
   */
  double contrast = 0;

  static constexpr double kLeastGain = 0.05;
  static constexpr double kLeastContrast = 0.3;

  bool canTell() const { return contrast >= kLeastContrast; }

  /** The best value is really better than 0. */
  bool differs() const { return canTell() && gain >= kLeastGain; }
};

/** How sharp one sensor's scans lie on each other at a track's poses: the fewer cells of 0.25 m
 * seen from above they fill, the sharper. Only a few stretches of the drive are looked at, those
 * that tell most. */
class Crispness
{
 public:
  /** `scans` in any order; those without a pose are left out. */
  Crispness(std::vector<Sighted> scans, const poses::PoseTrack& track);

  /** The time, s, to add to the sensor's stamps, within +-most_s, from the stretches with most
   * turning. Nothing where there are fewer than ten scans with poses. */
  std::optional<BestFit> timeOffset(double most_s = 0.5) const;

  /** The angle, deg, by which to turn the sensor's points about the vehicle's z, of all directions,
   * from the longest stretches. Nothing where there are fewer than ten scans with poses. */
  std::optional<BestFit> heading() const;

 private:
  struct Shift
  {
    double time_s = 0;
    double heading_rad = 0;
  };

  using Stretch = std::vector<size_t>;  // indices of scans_

  std::vector<Stretch> stretches() const;
  std::vector<Stretch> mostOf(bool turning) const;
  double filled(const std::vector<Stretch>& stretches, const Shift& shift) const;

  std::vector<Sighted> scans_;
  const poses::PoseTrack& track_;
};
}  // namespace traverse::diagnosis
