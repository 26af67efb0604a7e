// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace traverse::ros_bags
{
enum class MessageKind : uint8_t
{
  transforms,
  camera_info,
  point_cloud,
  laser_scan,
  image,
  odometry,
  imu,
  fix,
  velodyne,
};

/** A message definition that we read. */
struct KnownType
{
  std::string_view type;
  std::string_view md5sum;  //!< of the definition, as ROS computes it
  MessageKind kind;
};

inline constexpr std::array<KnownType, 10> kKnownTypes = {{
    {"tf2_msgs/TFMessage", "94810edda583a504dfda3829e70d7eec", MessageKind::transforms},
    {"tf/tfMessage", "94810edda583a504dfda3829e70d7eec", MessageKind::transforms},
    {"sensor_msgs/CameraInfo", "c9a58c1b0b154e0e6da7578cb991d214", MessageKind::camera_info},
    {"sensor_msgs/PointCloud2", "1158d486dd51d683ce2f1be655c3c181", MessageKind::point_cloud},
    {"sensor_msgs/LaserScan", "90c7ef2dc6895d81024acba2ac42f369", MessageKind::laser_scan},
    {"sensor_msgs/Image", "060021388200f6f0f447d0fcd9c64743", MessageKind::image},
    {"nav_msgs/Odometry", "cd5e73d190d741a2f92e81eda573aca7", MessageKind::odometry},
    {"sensor_msgs/Imu", "6a62c6daae103f4ff57a132d6f95cec2", MessageKind::imu},
    {"sensor_msgs/NavSatFix", "2d3a8cd499b9b4a0249fb98fd05cfa48", MessageKind::fix},
    {"velodyne_msgs/VelodyneScan", "50804fc9533a0e579e6322c04ae70566", MessageKind::velodyne},
}};

/** nullptr for a type that is not read. */
inline const KnownType* knownType(std::string_view type)
{
  for (const KnownType& known : kKnownTypes)
  {
    if (known.type == type)
    {
      return &known;
    }
  }
  return nullptr;
}
}  // namespace traverse::ros_bags
