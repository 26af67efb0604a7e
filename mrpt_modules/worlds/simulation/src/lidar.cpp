// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lidar_turn.h"
#include "recording_time.h"

#include <traverse/simulation/lidar.h>

#include <stdexcept>

namespace traverse::simulation
{
namespace
{
constexpr int64_t kNsPerUs = 1000;
constexpr int64_t kUsPerHour = 3'600'000'000;

/** Streams of random numbers of one sensor. */
enum Purpose : uint64_t
{
  kPackets = 1,
  kLosses = 2,
  kBiases = 3,
};
}  // namespace

Lidar::Lidar(const LidarParams& params, uint64_t seed) : params_(params), seed_(seed)
{
  options::check(params);
  if (params.mode == sensors::ReturnMode::dual)
  {
    throw std::invalid_argument("mode = dual is not simulated, only strongest and last");
  }
  turn_ns_ = nsOf(1 / params.rate_hz);
  packet_ns_ = sensors::kVelodyneBlocks * sensors::timingOf(params.model).blockNs();
  start_ns_ = nsOf(params.start_s);
  const auto lasers = static_cast<uint64_t>(sensors::timingOf(params.model).lasers);
  biases_m_.reserve(lasers);
  for (uint64_t laser = 0; laser < lasers; ++laser)
  {
    biases_m_.push_back(params.laser_bias_m * Random(mixed({seed, kBiases, laser})).normal());
  }
}

uint64_t Lidar::firstPacket(uint64_t k) const
{
  return (k * static_cast<uint64_t>(turn_ns_) + static_cast<uint64_t>(packet_ns_) - 1) /
         static_cast<uint64_t>(packet_ns_);
}

int64_t Lidar::packetStartNs(uint64_t packet) const
{
  return start_ns_ + static_cast<int64_t>(packet) * packet_ns_;
}

uint64_t Lidar::turnsUntil(double end_s) const
{
  const int64_t end_ns = nsOf(endWith(end_s, params_.dead_after_s));
  uint64_t turns = end_ns > start_ns_ ? static_cast<uint64_t>((end_ns - start_ns_) / turn_ns_) : 0;
  while (turns > 0 && packetStartNs(firstPacket(turns)) > end_ns)
  {
    --turns;
  }
  return turns;
}

poses::TimeNs Lidar::arrivalOf(uint64_t k) const
{
  return kRecordingStart + packetStartNs(firstPacket(k + 1)) + nsOf(params_.late_s);
}

bool Lidar::isLost(uint64_t k) const
{
  return params_.turn_loss > 0 && Random(mixed({seed_, kLosses, k})).chance(params_.turn_loss);
}

poses::TimeNs Lidar::clockErrorNs(uint64_t k) const
{
  const auto every = static_cast<uint64_t>(params_.backward_every);
  const bool backward = every > 0 && (k + 1) % every == 0;
  return nsOf(params_.clock_offset_s) - (backward ? turn_ns_ * 3 / 2 : 0);
}

LidarTurn Lidar::turn(uint64_t k, const RayCaster& scene, const Motion& drive) const
{
  LidarTurn turn;
  turn.number = k;
  turn.label = params_.label;
  turn.model = params_.model;
  turn.T_base_sensor = placeOf(params_);
  turn.arrival = arrivalOf(k);
  const uint64_t first = firstPacket(k);
  const uint64_t end = firstPacket(k + 1);
  turn.packets.reserve(end - first);
  turn.returns.reserve((end - first) * sensors::kVelodyneBlocks * sensors::kVelodyneRecords);
  PacketMaker maker(params_, {scene, drive, biases_m_}, turn_ns_, start_ns_);
  for (uint64_t packet = first; packet < end; ++packet)
  {
    const int64_t start_ns = packetStartNs(packet);
    Random random(mixed({seed_, kPackets, packet}));
    sensors::VelodynePacketContent content = maker.make(start_ns, random, turn.returns);
    const int64_t clock_us =
        (kRecordingStart + start_ns + clockErrorNs(k) + kNsPerUs / 2) / kNsPerUs;
    content.time_us = static_cast<uint32_t>(clock_us % kUsPerHour);
    turn.packets.push_back(sensors::encodeVelodyne(content));
    turn.stamp = packet == first ? clock_us * kNsPerUs : turn.stamp;
  }
  return turn;
}
}  // namespace traverse::simulation
