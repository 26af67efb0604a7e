// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "decoders.h"

#include <traverse/points/velodyne_scan.h>
#include <traverse/sensors/velodyne_packet.h>

#include <mrpt/obs/CObservationVelodyneScan.h>

#include <numbers>
#include <optional>
#include <vector>

namespace traverse::observations
{
namespace
{
using mrpt::obs::CObservationVelodyneScan;
static_assert(
    sizeof(CObservationVelodyneScan::TVelodyneRawPacket) == sensors::kVelodynePacketBytes);

std::vector<sensors::VelodynePacket> packetsOf(const CObservationVelodyneScan& scan)
{
  std::vector<sensors::VelodynePacket> packets;
  packets.reserve(scan.scan_packets.size());
  for (const auto& packet : scan.scan_packets)
  {
    packets.emplace_back(reinterpret_cast<const uint8_t*>(&packet), sizeof(packet));
  }
  return packets;
}

/** Of the first packet that is one. */
std::optional<sensors::VelodyneModel> modelOf(const std::vector<sensors::VelodynePacket>& packets)
{
  for (const sensors::VelodynePacket& packet : packets)
  {
    if (const auto data = sensors::VelodyneData::check(packet))
    {
      return data->model();
    }
  }
  return std::nullopt;
}

/** MRPT keeps the manufacturer's angles in degrees and offsets in metres, but no distance unit. */
sensors::VelodyneCalibration calibrationOf(
    const CObservationVelodyneScan& scan, sensors::VelodyneModel model)
{
  constexpr double kDegree = std::numbers::pi / 180;
  sensors::VelodyneCalibration calibration;
  calibration.distance_unit_m = sensors::factoryCalibration(model).distance_unit_m;
  calibration.lasers.reserve(scan.calibration.laser_corrections.size());
  for (const auto& laser : scan.calibration.laser_corrections)
  {
    calibration.lasers.push_back(
        {-laser.azimuthCorrection * kDegree, laser.verticalCorrection * kDegree,
         laser.distanceCorrection, laser.verticalOffsetCorrection,
         laser.horizontalOffsetCorrection});
  }
  return calibration;
}
}  // namespace

points::Decoded decodeVelodyneScan(const Request& request)
{
  const auto& scan = dynamic_cast<const CObservationVelodyneScan&>(request.observation);
  const std::vector<sensors::VelodynePacket> packets = packetsOf(scan);
  const auto model = modelOf(packets);
  if (!model && !packets.empty())
  {
    throw Refused("none of its packets is one of a VLP-16, HDL-32E or VLP-32C");
  }
  points::VelodyneInput input;
  input.packets = packets;
  input.stamp = stampOf(scan);
  input.sensor_label = scan.sensorLabel;
  input.T_base_sensor = sensorPoseOf(scan);
  input.limits = request.limits();
  sensors::VelodyneCalibration calibration;
  if (model && !scan.calibration.empty())
  {
    calibration = calibrationOf(scan, *model);
    if (!sensors::fits(calibration, *model))
    {
      throw Refused("its calibration does not fit a " + std::string(sensors::nameOf(*model)));
    }
    input.calibration = &calibration;
  }
  return points::decodeVelodyne(input);
}
}  // namespace traverse::observations
