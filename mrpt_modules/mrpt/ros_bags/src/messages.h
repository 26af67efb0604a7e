// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

// ROS 1 messages, taken out of their bytes by ourselves: every length is checked before it is used.
// The definitions are fixed by ROS and told apart by their md5sum (known_types.h).
namespace traverse::ros_bags
{
struct Header
{
  int64_t stamp_ns = 0;  //!< since 1970; 0: the driver gave none
  std::string frame;     //!< without a leading slash
};

/** Column of a PointCloud2. */
struct PointField
{
  std::string name;
  uint32_t offset = 0;
  uint8_t type = 0;  //!< 1..8: int8 uint8 int16 uint16 int32 uint32 float32 float64
};

/** sensor_msgs/PointCloud2; `data` looks into the message's bytes. Rows and points lie within it.
 */
struct PointCloud
{
  Header header;
  uint32_t height = 0, width = 0;
  std::vector<PointField> fields;
  bool big_endian = false;
  uint32_t point_step = 0, row_step = 0;
  std::string_view data;
};

struct LaserScan
{
  Header header;
  float angle_min_rad = 0, angle_max_rad = 0, step_rad = 0;
  float beam_time_s = 0, scan_time_s = 0;
  float range_min_m = 0, range_max_m = 0;
  std::vector<float> ranges_m, intensities;
};

/** sensor_msgs/Image; `data` looks into the message's bytes. Rows lie within it. */
struct Image
{
  Header header;
  uint32_t height = 0, width = 0;
  std::string encoding;
  bool big_endian = false;
  uint32_t step = 0;  //!< bytes from row to row
  std::string_view data;
};

struct CameraInfo
{
  Header header;
  uint32_t height = 0, width = 0;
  std::string distortion_model;
  std::vector<double> distortion;
  std::array<double, 9> k{};
  std::array<double, 12> p{};
  uint32_t binning_x = 0, binning_y = 0;  //!< 0 means 1
  uint32_t roi_x = 0, roi_y = 0;
};

struct Odometry
{
  Header header;
  std::string child_frame;
  Eigen::Isometry3d T_odom_child = Eigen::Isometry3d::Identity();
  std::array<double, 36> covariance{};  //!< x y z, then turns about the fixed axes x y z
  Eigen::Vector3d velocity_m_s = Eigen::Vector3d::Zero();
  Eigen::Vector3d turn_rad_s = Eigen::Vector3d::Zero();
};

struct Imu
{
  Header header;
  std::array<double, 4> orientation_xyzw{};
  Eigen::Vector3d turn_rad_s = Eigen::Vector3d::Zero();
  Eigen::Vector3d acceleration_m_s2 = Eigen::Vector3d::Zero();
  bool has_orientation = false, has_turn = false, has_acceleration = false;
};

struct NavSatFix
{
  Header header;
  int status = -1;  //!< -1 no fix, 0 fix, 1 with satellite, 2 with ground augmentation
  double latitude_deg = 0, longitude_deg = 0;
  double altitude_m = 0;  //!< above the ellipsoid
};

struct Transform
{
  Header header;  //!< its frame is the parent
  std::string child;
  Eigen::Isometry3d T_parent_child = Eigen::Isometry3d::Identity();
};

struct VelodynePackets
{
  static constexpr size_t kBytes = 1206;

  Header header;
  std::vector<std::pair<int64_t, std::string_view>> packets;  //!< received at (ns), kBytes
};

// Each throws formats::FormatError where the bytes are not exactly one such message, or what it
// says of its own layout does not fit. Values of measurements may be anything, NaN too, but
// rotations are rotations.
PointCloud parsePointCloud(std::string_view bytes);
LaserScan parseLaserScan(std::string_view bytes);
Image parseImage(std::string_view bytes);
CameraInfo parseCameraInfo(std::string_view bytes);
Odometry parseOdometry(std::string_view bytes);
Imu parseImu(std::string_view bytes);
NavSatFix parseNavSatFix(std::string_view bytes);
std::vector<Transform> parseTransforms(std::string_view bytes);  //!< without those that are none
VelodynePackets parseVelodynePackets(std::string_view bytes);
}  // namespace traverse::ros_bags
