// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "oxts.h"

#include "folders.h"

#include <traverse/observations/convert.h>

#include <mrpt/obs/CObservationGPS.h>
#include <mrpt/obs/CObservationIMU.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace traverse::importing
{
namespace
{
enum Place : size_t
{
  kLatitude = 0,
  kLongitude = 1,
  kAltitude = 2,
  kRoll = 3,
  kPitch = 4,
  kYaw = 5,
  kForward = 8,
  kLeft = 9,
  kUp = 10,
  kAccelerationX = 11,
  kRateX = 17,
  kSatellites = 26,
};

mrpt::obs::gnss::UTC_time utcOf(poses::TimeNs stamp)
{
  constexpr poses::TimeNs kDay_ns = 86'400'000'000'000;
  const double s = static_cast<double>(stamp % kDay_ns) * 1e-9;
  mrpt::obs::gnss::UTC_time utc;
  utc.hour = static_cast<uint8_t>(s / 3600);
  utc.minute = static_cast<uint8_t>(std::fmod(s / 60, 60));
  utc.sec = std::fmod(s, 60);
  return utc;
}
}  // namespace

Oxts readOxts(const std::string& text)
{
  const std::vector<double> values = numbersOf(text);
  Oxts oxts{};
  if (values.size() != oxts.size() || std::abs(values[kLatitude]) > 90 ||
      std::abs(values[kLongitude]) > 360 || std::abs(values[kAltitude]) > 1e5)
  {
    throw ImportError("a line of GPS and IMU that is none");
  }
  std::copy(values.begin(), values.end(), oxts.begin());
  return oxts;
}

Entry gpsEntry(const Oxts& oxts, const SensorAt& sensor)
{
  mrpt::obs::gnss::Message_NMEA_GGA message;
  message.fields.UTCTime = utcOf(sensor.stamp);
  message.fields.latitude_degrees = oxts[kLatitude];
  message.fields.longitude_degrees = oxts[kLongitude];
  message.fields.altitude_meters = oxts[kAltitude];
  message.fields.fix_quality = 1;
  message.fields.satellitesUsed = static_cast<uint32_t>(std::clamp(oxts[kSatellites], 0.0, 100.0));
  message.fields.thereis_HDOP = false;
  auto observation = mrpt::obs::CObservationGPS::Create();
  observation->sensorLabel = sensor.label;
  observation->timestamp = observations::toTimePoint(sensor.stamp);
  observation->originalReceivedTimestamp = observation->timestamp;
  observation->has_satellite_timestamp = false;
  observation->sensorPose = observations::toPose3D(sensor.T_base_sensor);
  observation->setMsg(message);
  return {observation, {}};
}

Entry imuEntry(const Oxts& oxts, const SensorAt& sensor)
{
  using namespace mrpt::obs;  // NOLINT(google-build-using-namespace): names of MRPT's enum
  auto observation = CObservationIMU::Create();
  observation->sensorLabel = sensor.label;
  observation->timestamp = observations::toTimePoint(sensor.stamp);
  observation->sensorPose = observations::toPose3D(sensor.T_base_sensor);
  const std::array<std::pair<TIMUDataIndex, size_t>, 12> all = {
      {{IMU_X_ACC, kAccelerationX},
       {IMU_Y_ACC, kAccelerationX + 1},
       {IMU_Z_ACC, kAccelerationX + 2},
       {IMU_WX, kRateX},
       {IMU_WY, kRateX + 1},
       {IMU_WZ, kRateX + 2},
       {IMU_X_VEL, kForward},
       {IMU_Y_VEL, kLeft},
       {IMU_Z_VEL, kUp},
       {IMU_YAW, kYaw},
       {IMU_PITCH, kPitch},
       {IMU_ROLL, kRoll}}};
  for (const auto& [index, place] : all)
  {
    observation->set(index, oxts[place]);
  }
  return {observation, {}};
}
}  // namespace traverse::importing
