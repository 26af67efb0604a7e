// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "velodyne_turns.h"

#include <traverse/observations/convert.h>

#include <mrpt/obs/CObservationVelodyneScan.h>

#include <cstdlib>
#include <cstring>

namespace traverse::importing
{
namespace
{
using mrpt::obs::CObservationVelodyneScan;
constexpr poses::TimeNs kHour_ns = 3'600'000'000'000;
constexpr size_t kMostPackets = 4096;  // of a turn: four of the slowest and fullest
constexpr int kHalfTurn = 18000;       // hundredths of a degree

/** MRPT's own tables where it has them; for a VLP-32C ours is used, which decodes it. */
mrpt::obs::VelodyneCalibration calibrationOf(sensors::VelodyneModel model)
{
  switch (model)
  {
    case sensors::VelodyneModel::vlp16:
      return mrpt::obs::VelodyneCalibration::LoadDefaultCalibration("VLP16");
    case sensors::VelodyneModel::hdl32e:
      return mrpt::obs::VelodyneCalibration::LoadDefaultCalibration("HDL32");
    case sensors::VelodyneModel::vlp32c:
      break;
  }
  return {};
}
}  // namespace

poses::TimeNs VelodyneTurns::stampOf(const sensors::VelodyneData& data, poses::TimeNs captured)
{
  constexpr poses::TimeNs kTrusted_ns = 500'000'000;
  const poses::TimeNs in_hour = poses::TimeNs{data.timeUs()} * 1000;
  // The sensor's clock is steadier than the capture's, which knows the hour.
  poses::TimeNs stamp = hour_.value_or(captured - in_hour) + in_hour;
  if (captured - stamp > kHour_ns / 2)
  {
    stamp += kHour_ns;
  }
  stamp = std::abs(stamp - captured) < kTrusted_ns ? stamp : captured;
  hour_ = stamp - in_hour;
  return stamp;
}

void VelodyneTurns::begin(const sensors::VelodyneData& data, poses::TimeNs captured)
{
  turn_ = CObservationVelodyneScan::Create();
  turn_->sensorLabel = sensor_.label;
  turn_->timestamp = observations::toTimePoint(stampOf(data, captured));
  turn_->originalReceivedTimestamp = observations::toTimePoint(captured);
  turn_->has_satellite_timestamp = false;
  turn_->sensorPose = observations::toPose3D(sensor_.T_base_sensor);
  turn_->minRange = 0;
  turn_->maxRange = 200;
  turn_->calibration = calibrationOf(data.model());
}

bool VelodyneTurns::add(std::span<const uint8_t> packet, poses::TimeNs captured)
{
  const auto data = sensors::VelodyneData::check(packet);
  if (!data || data->model() != model_.value_or(data->model()))
  {
    return false;
  }
  model_ = data->model();
  const uint16_t azimuth = data->azimuth(0);
  const bool wrapped = last_azimuth_ - azimuth > kHalfTurn;
  last_azimuth_ = azimuth;
  if (turn_ && (wrapped || turn_->scan_packets.size() == kMostPackets))
  {
    finished_ = std::move(turn_);
    turn_ = nullptr;
  }
  if (!turn_)
  {
    begin(*data, captured);
  }
  auto& raw = turn_->scan_packets.emplace_back();
  static_assert(sizeof(raw) == sensors::kVelodynePacketBytes);
  std::memcpy(static_cast<void*>(&raw), packet.data(), sizeof(raw));
  return true;
}

std::optional<Entry> VelodyneTurns::takeFinished()
{
  if (!finished_)
  {
    return std::nullopt;
  }
  return Entry{std::move(finished_), {}};
}

std::optional<Entry> VelodyneTurns::finish()
{
  if (!turn_)
  {
    return std::nullopt;
  }
  return Entry{std::move(turn_), {}};
}
}  // namespace traverse::importing
