// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lidar_turn.h"

#include "recording_time.h"

#include <array>
#include <cmath>

namespace traverse::simulation
{
Eigen::Isometry3d placeOf(const LidarParams& params)
{
  const auto turned = [](double angle_deg, const Eigen::Vector3d& axis)
  { return poses::rotationBy(angle_deg * sensors::kRadPerDegree, axis); };
  Eigen::Isometry3d T_base_sensor = Eigen::Isometry3d::Identity();
  T_base_sensor.linear() = turned(params.yaw_deg, Eigen::Vector3d::UnitZ()) *
                           turned(params.pitch_deg, Eigen::Vector3d::UnitY()) *
                           turned(params.roll_deg, Eigen::Vector3d::UnitX());
  T_base_sensor.translation() = Eigen::Vector3d(params.x_m, params.y_m, params.z_m);
  return T_base_sensor;
}

PacketMaker::PacketMaker(
    const LidarParams& params, const World& world, int64_t turn_ns, int64_t begin_ns) :
    params_(params),
    world_(world),
    timing_(sensors::timingOf(params.model)),
    lasers_(lasersOf(params.model)),
    encoder_(params.phase_deg, turn_ns),
    receiver_(params, world.biases_m),
    T_base_sensor_(placeOf(params)),
    begin_ns_(begin_ns),
    last_pose_ns_(begin_ns),
    last_pose_(sensorPose(begin_ns))
{
}

Eigen::Isometry3d PacketMaker::sensorPose(int64_t time_ns) const
{
  return world_.drive.at(secondsOf(time_ns)) * T_base_sensor_;
}

/** Sequences follow each other, so that one's end is the next one's beginning. */
MovingPlacement PacketMaker::placementFrom(int64_t start_ns)
{
  const Eigen::Isometry3d from = last_pose_ns_ == start_ns ? last_pose_ : sensorPose(start_ns);
  last_pose_ns_ = start_ns + timing_.sequence_ns;
  last_pose_ = sensorPose(last_pose_ns_);
  return {from, last_pose_};
}

void PacketMaker::fireSequence(
    int64_t start_ns,
    Random& random,
    sensors::VelodyneReturn* records,
    std::vector<ReturnTruth>& truth)
{
  const MovingPlacement placement = placementFrom(start_ns);
  const double jitter_units =
      params_.azimuth_jitter_deg > 0
          ? random.normal() * params_.azimuth_jitter_deg * sensors::kUnitsPerDegree
          : 0;
  const auto jitter = static_cast<sensors::AzimuthUnits>(std::floor(jitter_units + 0.5));
  std::array<Caught, sensors::kVelodyneRecords> caught;
  std::array<NormalDraw, sensors::kVelodyneRecords> draws;
  for (size_t i = 0; i < lasers_.size(); ++i)
  {
    const SimulatedLaser& laser = lasers_[i];
    const int64_t time_ns = start_ns + laser.firing_ns;
    const sensors::SinCos a = sensors::sinCosOf(
        sensors::wrapped(encoder_.azimuth(time_ns - begin_ns_) + laser.azimuth_offset + jitter));
    const Eigen::Vector3d in_sensor(
        laser.elevation.cos * a.cos, -laser.elevation.cos * a.sin, laser.elevation.sin);
    const double fraction =
        static_cast<double>(laser.firing_ns) / static_cast<double>(timing_.sequence_ns);
    const Ray ray{
        placement.origin(fraction), placement.direction(in_sensor, fraction), secondsOf(time_ns)};
    caught[i] = receiver_.receive(world_.scene.cast(ray, receiver_.maxRangeMetres()), random);
    draws[i] = caught[i].noise;
  }
  std::array<double, sensors::kVelodyneRecords> noise{};
  normalsOf({draws.data(), lasers_.size()}, noise);
  for (size_t i = 0; i < lasers_.size(); ++i)
  {
    const Measured measured = receiver_.measure(i, caught[i], noise[i]);
    *records++ = measured.record;
    if (measured.record.distance > 0)
    {
      truth.push_back(measured.truth);
    }
  }
}

sensors::VelodynePacketContent PacketMaker::make(
    int64_t start_ns, Random& random, std::vector<ReturnTruth>& truth)
{
  sensors::VelodynePacketContent content;
  content.model = params_.model;
  content.mode = params_.mode;
  for (size_t b = 0; b < content.blocks.size(); ++b)
  {
    sensors::VelodyneBlock& block = content.blocks[b];
    const int64_t block_ns = start_ns + static_cast<int64_t>(b) * timing_.blockNs();
    block.azimuth = Encoder::hundredths(encoder_.azimuth(block_ns - begin_ns_));
    for (int sequence = 0; sequence < timing_.sequences_per_block; ++sequence)
    {
      fireSequence(
          block_ns + sequence * timing_.sequence_ns, random,
          &block.records[static_cast<size_t>(sequence) * lasers_.size()], truth);
    }
  }
  return content;
}
}  // namespace traverse::simulation
