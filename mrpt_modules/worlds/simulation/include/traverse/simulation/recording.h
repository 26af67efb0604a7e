// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/vehicle.h>
#include <traverse/simulation/drive.h>
#include <traverse/simulation/lidar.h>
#include <traverse/simulation/pose_sensors.h>
#include <traverse/simulation/ray_caster.h>

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

namespace traverse::simulation
{
/** What drives where, with which sensors. */
struct RecordingParams
{
  geometry::Vehicle vehicle;
  DriveParams drive;
  std::vector<LidarParams> lidars = {LidarParams{}};
  InsParams ins;
  OdometryParams odometry;

  friend bool operator==(const RecordingParams&, const RecordingParams&) = default;
};

/** What a recording consists of. */
using Event = std::variant<LidarTurn, InsPose, OdometryPose>;

/** What a vehicle with its sensors records of a scene, in the order in which it arrives (at equal
 * times: lidars as they are listed, INS, odometry). The same scene, parameters and seed give the
 * same bytes.
 *
 * next() is for those who want one event after the other; with plan() and make() events can be made
 * by many threads. */
class Recording
{
 public:
  /** An event that is due: of a lidar (its number), or behind those of the INS, of the odometry. */
  struct Planned
  {
    poses::TimeNs arrival = 0;
    size_t sensor = 0;
    uint64_t number = 0;  //!< of the sensor's
  };

  /** Copies what it needs. Throws what RayCaster and driveOn() throw, and what Lidar does. */
  Recording(const Scene& scene, const RecordingParams& params, uint64_t seed);

  /** The next event; nothing at the end. */
  std::optional<Event> next();

  /** Goes one event on without making it. */
  std::optional<Planned> plan();

  /** For use by many threads at once. */
  Event make(const Planned& planned) const;

  /** Goes to the first event that arrives at a true time or later. */
  void seek(poses::TimeNs arrival);

  /** Share of the recording's time that is behind, 0..1. */
  double progress() const;

  /** Of the recording, s. */
  double durationSeconds() const { return duration_s_; }

  /** T_map_base by the scene's time. */
  const Motion& drive() const { return drive_; }

  /** Exact, from the first moment to the last; 100 Hz has all that there is to know. */
  std::vector<poses::StampedPose> trajectory(double rate_hz) const;

 private:
  /** One sensor's events. */
  struct Stream
  {
    uint64_t next = 0;
    uint64_t end = 0;
    bool again = false;  //!< `next` has arrived once and arrives a second time
  };

  size_t insNumber() const { return lidars_.size(); }

  poses::TimeNs arrivalOf(size_t sensor, uint64_t number) const;
  bool isLost(size_t sensor, uint64_t number) const;
  void skipLost(size_t sensor);
  void advance(size_t sensor);

  RayCaster caster_;
  Motion drive_;
  double duration_s_;
  std::vector<Lidar> lidars_;
  Ins ins_;
  std::vector<OdometryPose> odometry_;
  std::vector<Stream> streams_;
  poses::TimeNs now_;
};
}  // namespace traverse::simulation
