// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "convert.h"

#include <traverse/formats/bytes.h>
#include <traverse/observations/convert.h>

#include <mrpt/obs/CObservationGPS.h>
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/poses/CPose3D.h>

#include <algorithm>
#include <cmath>

namespace traverse::ros_bags
{
namespace
{
void setCovariance(mrpt::math::CMatrixDouble66& to, const std::array<double, 36>& from)
{
  // ROS: turns about x, y, z. MRPT: yaw, pitch, roll.
  constexpr std::array<size_t, 6> kRosRow = {0, 1, 2, 5, 4, 3};
  to.setZero();
  if (!std::all_of(from.begin(), from.end(), [](double v) { return std::isfinite(v); }))
  {
    return;
  }
  for (int r = 0; r < 6; ++r)
  {
    for (int c = 0; c < 6; ++c)
    {
      to(r, c) = from[kRosRow[static_cast<size_t>(r)] * 6 + kRosRow[static_cast<size_t>(c)]];
    }
  }
}

importing::Entry fromSpatial(const Odometry& odometry, const Origin& origin, Surroundings& around)
{
  auto to = mrpt::obs::CObservationRobotPose::Create();
  to->pose.mean = observations::toPose3D(odometry.T_odom_child);
  setCovariance(to->pose.cov, odometry.covariance);
  to->sensorPose = around.sensorPose(odometry.child_frame, origin.stamp_ns);
  return {to, {}};
}

void set(mrpt::obs::CObservationIMU& to, mrpt::obs::TIMUDataIndex what, double value)
{
  if (std::isfinite(value))
  {
    to.set(what, value);
  }
}
}  // namespace

importing::Entry fromOdometry(const Odometry& odometry, const Origin& origin, Surroundings& around)
{
  if (around.spatialOdometry(origin.topic))
  {
    return fromSpatial(odometry, origin, around);
  }
  auto to = mrpt::obs::CObservationOdometry::Create();
  to->odometry = mrpt::poses::CPose2D(observations::toPose3D(odometry.T_odom_child));
  to->hasVelocities = odometry.velocity_m_s.allFinite() && odometry.turn_rad_s.allFinite();
  if (to->hasVelocities)
  {
    to->velocityLocal = {
        odometry.velocity_m_s.x(), odometry.velocity_m_s.y(), odometry.turn_rad_s.z()};
  }
  return {to, {}};
}

importing::Entry fromImu(const Imu& imu, const Origin& origin, Surroundings& around)
{
  using namespace mrpt::obs;
  auto to = CObservationIMU::Create();
  if (imu.has_acceleration)
  {
    set(*to, IMU_X_ACC, imu.acceleration_m_s2.x());
    set(*to, IMU_Y_ACC, imu.acceleration_m_s2.y());
    set(*to, IMU_Z_ACC, imu.acceleration_m_s2.z());
  }
  if (imu.has_turn)
  {
    set(*to, IMU_WX, imu.turn_rad_s.x());
    set(*to, IMU_WY, imu.turn_rad_s.y());
    set(*to, IMU_WZ, imu.turn_rad_s.z());
  }
  const auto& q = imu.orientation_xyzw;
  const double norm = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
  constexpr double kFarFromUnit = 0.1;
  if (imu.has_orientation && std::abs(norm - 1) < kFarFromUnit)
  {
    set(*to, IMU_ORI_QUAT_X, q[0] / norm);
    set(*to, IMU_ORI_QUAT_Y, q[1] / norm);
    set(*to, IMU_ORI_QUAT_Z, q[2] / norm);
    set(*to, IMU_ORI_QUAT_W, q[3] / norm);
    const mrpt::poses::CPose3D turn(
        mrpt::math::CQuaternionDouble(q[3] / norm, q[0] / norm, q[1] / norm, q[2] / norm), 0, 0, 0);
    set(*to, IMU_YAW, turn.yaw());
    set(*to, IMU_PITCH, turn.pitch());
    set(*to, IMU_ROLL, turn.roll());
  }
  to->sensorPose = around.sensorPose(imu.header.frame, origin.stamp_ns);
  return {to, {}};
}

importing::Entry fromFix(const NavSatFix& fix, const Origin& origin, Surroundings& around)
{
  constexpr double kMostLatitude = 90;
  constexpr double kMostLongitude = 360;
  const bool there = fix.status >= 0 && std::abs(fix.latitude_deg) <= kMostLatitude &&
                     std::abs(fix.longitude_deg) <= kMostLongitude && std::isfinite(fix.altitude_m);
  if (!there)
  {
    throw formats::FormatError("NavSatFix: no fix");
  }
  constexpr int64_t kNsPerS = 1'000'000'000;
  const int64_t of_day_s = origin.stamp_ns / kNsPerS % 86400;
  mrpt::obs::gnss::Message_NMEA_GGA gga;
  gga.fields.UTCTime.hour = static_cast<uint8_t>(of_day_s / 3600);
  gga.fields.UTCTime.minute = static_cast<uint8_t>(of_day_s / 60 % 60);
  gga.fields.UTCTime.sec =
      static_cast<double>(of_day_s % 60) + static_cast<double>(origin.stamp_ns % kNsPerS) / kNsPerS;
  gga.fields.latitude_degrees = fix.latitude_deg;
  gga.fields.longitude_degrees = fix.longitude_deg;
  gga.fields.altitude_meters = fix.altitude_m;
  gga.fields.fix_quality = fix.status == 0 ? 1 : 2;
  auto to = mrpt::obs::CObservationGPS::Create();
  to->setMsg(gga);
  to->originalReceivedTimestamp = observations::toTimePoint(origin.stamp_ns);
  to->sensorPose = around.sensorPose(fix.header.frame, origin.stamp_ns);
  return {to, {}};
}
}  // namespace traverse::ros_bags
