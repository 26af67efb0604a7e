// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/poses/pose_track.h>
#include <traverse/sensors/velodyne.h>
#include <traverse/simulation/lidar_params.h>
#include <traverse/simulation/motion.h>
#include <traverse/simulation/ray_caster.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace traverse::simulation
{
/** The true time at second 0 of every recording: 2020-01-01, 00:00 UTC. */
inline constexpr poses::TimeNs kRecordingStart = 1'577'836'800'000'000'000;

/** What a return came from. */
struct ReturnTruth
{
  uint32_t object = Scene::kNoObject;  //!< rain: kNoObject
  Label label = Label::none;
  Material material = Material::soil;
  float range_m = 0;  //!< from the sensor, without noise

  friend bool operator==(const ReturnTruth&, const ReturnTruth&) = default;
};

/** One revolution of a lidar, as it sends it. */
struct LidarTurn
{
  uint64_t number = 0;        //!< the turns of a sensor count from 0
  poses::TimeNs stamp = 0;    //!< of the first firing, by the sensor's own clock (and its faults)
  poses::TimeNs arrival = 0;  //!< true time at which the last packet is there
  std::string label;
  sensors::VelodyneModel model = sensors::VelodyneModel::hdl32e;
  Eigen::Isometry3d T_base_sensor = Eigen::Isometry3d::Identity();
  std::vector<std::array<uint8_t, sensors::kVelodynePacketBytes>> packets;

  /** One for every point that points::decodeVelodyne, without limits of range, yields of the
   * packets, in its order. */
  std::vector<ReturnTruth> returns;
};

/** A Velodyne sensor on a vehicle: every laser's own direction and firing time, the packets'
 * rounding of azimuths and distances, a clock that wraps at the hour. Dual mode is not simulated.
 *
 * Turn k depends on the scene, the parameters, the seed and k only: turns can be made in any order
 * and by many threads. A turn has the packets that begin within 1 / rate_hz. */
class Lidar
{
 public:
  /** Throws std::invalid_argument for a mode that is not simulated, options::OptionError for
   * options out of range. */
  Lidar(const LidarParams& params, uint64_t seed);

  /** How many turns are over by a time of the recording, s. */
  uint64_t turnsUntil(double end_s) const;

  /** True time at which turn k is there, its lateness included. */
  poses::TimeNs arrivalOf(uint64_t k) const;

  /** True where turn k gets lost on its way. */
  bool isLost(uint64_t k) const;

  /** Makes turn k of a drive; t = 0 of `drive` and of the scene is kRecordingStart. */
  LidarTurn turn(uint64_t k, const RayCaster& scene, const Motion& drive) const;

  const LidarParams& params() const { return params_; }

 private:
  /** Packets count from the sensor's first. */
  uint64_t firstPacket(uint64_t k) const;
  int64_t packetStartNs(uint64_t packet) const;  //!< of the recording
  poses::TimeNs clockErrorNs(uint64_t k) const;

  LidarParams params_;
  uint64_t seed_;
  int64_t turn_ns_;
  int64_t packet_ns_;
  int64_t start_ns_;
  std::vector<double> biases_m_;  //!< of the lasers
};
}  // namespace traverse::simulation
