// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/observations/convert.h>
#include <traverse/sensors/exact_angle.h>
#include <traverse/sensors/velodyne_timing.h>
#include <traverse/simulating/observations.h>

#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/obs/CObservationVelodyneScan.h>

#include <cmath>
#include <cstring>

namespace traverse::simulating
{
namespace
{
using mrpt::obs::CObservationVelodyneScan;

/** Our table as MRPT keeps it: degrees, azimuths with the other sign, and their sines and cosines,
 * which it does not work out itself. */
mrpt::obs::VelodyneCalibration calibrationOf(sensors::VelodyneModel model)
{
  mrpt::obs::VelodyneCalibration calibration;
  const auto lasers = static_cast<size_t>(sensors::timingOf(model).lasers);
  for (size_t i = 0; i < lasers; ++i)
  {
    const auto& from = sensors::factoryCalibration(model).lasers[i];
    auto& to = calibration.laser_corrections.emplace_back();
    const auto in_degrees = [](double angle_rad)  // the table's thousandths again
    { return std::floor(angle_rad / sensors::kRadPerDegree * 1000 + 0.5) / 1000; };
    to.azimuthCorrection = 0 - in_degrees(from.azimuth_offset_rad);
    to.verticalCorrection = in_degrees(from.elevation_rad);
    const geometry::SinCos elevation = geometry::sinCosOf(from.elevation_rad);
    to.sinVertCorrection = elevation.sin;
    to.cosVertCorrection = elevation.cos;
    to.sinVertOffsetCorrection = 0;
    to.cosVertOffsetCorrection = 0;
  }
  return calibration;
}

mrpt::obs::CObservation::Ptr observationOf(
    const simulation::LidarTurn& turn, const simulation::RecordingParams& params)
{
  auto scan = CObservationVelodyneScan::Create();
  scan->timestamp = observations::toTimePoint(turn.stamp);
  scan->originalReceivedTimestamp = observations::toTimePoint(turn.arrival);
  scan->has_satellite_timestamp = false;
  scan->sensorPose = observations::toPose3D(turn.T_base_sensor);
  scan->minRange = 0;
  scan->maxRange = static_cast<double>(sensors::timingOf(turn.model).max_range_m);
  for (const simulation::LidarParams& lidar : params.lidars)
  {
    const bool is_it = lidar.label == turn.label && lidar.max_range_m > 0;
    scan->maxRange = is_it ? lidar.max_range_m : scan->maxRange;
  }
  scan->calibration = calibrationOf(turn.model);
  scan->scan_packets.reserve(turn.packets.size());
  for (const auto& packet : turn.packets)
  {
    auto& raw = scan->scan_packets.emplace_back();
    static_assert(sizeof(raw) == sensors::kVelodynePacketBytes);
    std::memcpy(static_cast<void*>(&raw), packet.data(), sizeof(raw));
  }
  return scan;
}

mrpt::obs::CObservation::Ptr observationOf(
    const simulation::InsPose& pose, const simulation::RecordingParams& params)
{
  constexpr double kSmallest = 1e-6;  // a singular covariance would break those who weigh by it
  auto said = mrpt::obs::CObservationRobotPose::Create();
  said->timestamp = observations::toTimePoint(pose.stamp);
  said->pose.mean = observations::toPose3D(pose.T_map_base);
  const double turn_rad = params.ins.noise_deg * sensors::kRadPerDegree;
  said->pose.cov.setZero();
  for (int i = 0; i < 6; ++i)
  {
    const double place_m = i == 2 ? params.ins.noise_z_m : params.ins.noise_xy_m;
    const double deviation = i < 3 ? place_m : turn_rad;
    said->pose.cov(i, i) = deviation * deviation + kSmallest;
  }
  return said;
}

mrpt::obs::CObservation::Ptr observationOf(
    const simulation::OdometryPose& pose, const simulation::RecordingParams& /*params*/)
{
  auto said = mrpt::obs::CObservationOdometry::Create();
  said->timestamp = observations::toTimePoint(pose.stamp);
  said->odometry = mrpt::poses::CPose2D(pose.x_m, pose.y_m, pose.yaw_rad);
  said->hasEncodersInfo = false;
  said->hasVelocities = false;
  return said;
}
}  // namespace

mrpt::obs::CObservation::Ptr toObservation(
    const simulation::Event& event, const simulation::RecordingParams& params)
{
  return std::visit(
      [&](const auto& what)
      {
        auto observation = observationOf(what, params);
        observation->sensorLabel = what.label;
        return observation;
      },
      event);
}
}  // namespace traverse::simulating
