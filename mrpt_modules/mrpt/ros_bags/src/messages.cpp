// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "messages.h"

#include "message_bytes.h"

namespace traverse::ros_bags
{
namespace
{
/** -1 at the first entry of a covariance says: not measured. */
bool measured(const std::array<double, 9>& covariance)
{
  return covariance[0] != -1;
}
}  // namespace

LaserScan parseLaserScan(std::string_view bytes)
{
  MessageBytes in(bytes, "LaserScan");
  LaserScan scan;
  scan.header = in.header();
  for (float* value :
       {&scan.angle_min_rad, &scan.angle_max_rad, &scan.step_rad, &scan.beam_time_s,
        &scan.scan_time_s, &scan.range_min_m, &scan.range_max_m})
  {
    *value = in.f32();
  }
  scan.ranges_m = in.numbers<float>();
  scan.intensities = in.numbers<float>();
  in.expectEnd();
  return scan;
}

CameraInfo parseCameraInfo(std::string_view bytes)
{
  MessageBytes in(bytes, "CameraInfo");
  CameraInfo info;
  info.header = in.header();
  info.height = in.u32();
  info.width = in.u32();
  info.distortion_model = in.text();
  info.distortion = in.numbers<double>();
  info.k = in.fixed<double, 9>();
  in.fixed<double, 9>();  // R, of stereo rectification
  info.p = in.fixed<double, 12>();
  info.binning_x = in.u32();
  info.binning_y = in.u32();
  info.roi_x = in.u32();
  info.roi_y = in.u32();
  in.u32();
  in.u32();  // the region's size: the image has it
  in.u8();
  in.expectEnd();
  return info;
}

Odometry parseOdometry(std::string_view bytes)
{
  MessageBytes in(bytes, "Odometry");
  Odometry odometry;
  odometry.header = in.header();
  odometry.child_frame = in.frame();
  odometry.T_odom_child = in.motion();
  odometry.covariance = in.fixed<double, 36>();
  odometry.velocity_m_s = in.vector();
  odometry.turn_rad_s = in.vector();
  in.fixed<double, 36>();  // no class of MRPT has room for the covariance of a velocity
  in.expectEnd();
  return odometry;
}

Imu parseImu(std::string_view bytes)
{
  MessageBytes in(bytes, "Imu");
  Imu imu;
  imu.header = in.header();
  imu.orientation_xyzw = in.fixed<double, 4>();
  imu.has_orientation = measured(in.fixed<double, 9>());
  imu.turn_rad_s = in.vector();
  imu.has_turn = measured(in.fixed<double, 9>());
  imu.acceleration_m_s2 = in.vector();
  imu.has_acceleration = measured(in.fixed<double, 9>());
  in.expectEnd();
  return imu;
}

NavSatFix parseNavSatFix(std::string_view bytes)
{
  MessageBytes in(bytes, "NavSatFix");
  NavSatFix fix;
  fix.header = in.header();
  fix.status = static_cast<int8_t>(in.u8());
  in.u16();  // which satellites
  fix.latitude_deg = in.f64();
  fix.longitude_deg = in.f64();
  fix.altitude_m = in.f64();
  in.fixed<double, 9>();  // MRPT 2.5.8 has no place for the covariance of a fix
  in.u8();
  in.expectEnd();
  return fix;
}

std::vector<Transform> parseTransforms(std::string_view bytes)
{
  MessageBytes in(bytes, "TFMessage");
  constexpr size_t kLeast = 76;  // header 16, child 4, motion 56
  const size_t n = in.elements(kLeast);
  std::vector<Transform> all;
  all.reserve(n);
  for (size_t i = 0; i < n; ++i)
  {
    Transform transform{in.header(), in.frame(), {}};
    // One broken joint must not take the others of its message with it.
    if (const auto motion = in.motionIfAny())
    {
      transform.T_parent_child = *motion;
      all.push_back(std::move(transform));
    }
  }
  in.expectEnd();
  return all;
}

VelodynePackets parseVelodynePackets(std::string_view bytes)
{
  MessageBytes in(bytes, "VelodyneScan");
  VelodynePackets scan;
  scan.header = in.header();
  scan.packets.resize(in.elements(VelodynePackets::kBytes + 8));
  for (auto& [stamp_ns, packet] : scan.packets)
  {
    stamp_ns = in.time();
    packet = in.raw(VelodynePackets::kBytes);
  }
  in.expectEnd();
  return scan;
}
}  // namespace traverse::ros_bags
