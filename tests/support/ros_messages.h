// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <nav_msgs/Odometry.h>
#include <ros/serialization.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/NavSatFix.h>
#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/PointField.h>
#include <string>
#include <tf2_msgs/TFMessage.h>
#include <utility>
#include <vector>

// Messages as ROS's own headers make them.
namespace traverse::testing
{
/** ROS's headers want of an allocator what C++20 has taken away. */
template <class T>
struct RosVectorAllocator : std::allocator<T>
{
  RosVectorAllocator() = default;

  template <class U>
  RosVectorAllocator(const RosVectorAllocator<U>& /*other*/)  // NOLINT: allocators convert
  {
  }

  template <class U>
  struct rebind  // NOLINT(readability-identifier-naming): the standard's name
  {
    using other = RosVectorAllocator<U>;
  };
};

/** Texts stay std::string. */
struct RosAllocator : std::allocator<void>
{
  template <class T>
  struct rebind  // NOLINT(readability-identifier-naming): the standard's name
  {
    using other =
        std::conditional_t<std::is_same_v<T, char>, std::allocator<char>, RosVectorAllocator<T>>;
  };
};

namespace msgs
{
using Header = std_msgs::Header_<RosAllocator>;
using PointField = sensor_msgs::PointField_<RosAllocator>;
using PointCloud2 = sensor_msgs::PointCloud2_<RosAllocator>;
using LaserScan = sensor_msgs::LaserScan_<RosAllocator>;
using Image = sensor_msgs::Image_<RosAllocator>;
using CameraInfo = sensor_msgs::CameraInfo_<RosAllocator>;
using Imu = sensor_msgs::Imu_<RosAllocator>;
using NavSatFix = sensor_msgs::NavSatFix_<RosAllocator>;
using Odometry = nav_msgs::Odometry_<RosAllocator>;
using TFMessage = tf2_msgs::TFMessage_<RosAllocator>;
using TransformStamped = geometry_msgs::TransformStamped_<RosAllocator>;
using Vector3 = geometry_msgs::Vector3_<RosAllocator>;
}  // namespace msgs

inline constexpr uint32_t kBagStart_s = 1'600'000'000;

/** The bytes of a message, by ROS's serialiser. */
template <class M>
std::string rosBytes(const M& message)
{
  std::string bytes(ros::serialization::serializationLength(message), '\0');
  ros::serialization::OStream out(
      reinterpret_cast<uint8_t*>(bytes.data()), static_cast<uint32_t>(bytes.size()));
  ros::serialization::serialize(out, message);
  return bytes;
}

/** Seconds after the recordings' start. */
inline ros::Time rosTime(double after_s)
{
  return ros::Time(kBagStart_s, 0) + ros::Duration(after_s);
}

inline msgs::Header rosHeader(double after_s, const std::string& frame)
{
  msgs::Header header;
  header.stamp = rosTime(after_s);
  header.frame_id = frame;
  return header;
}

/** Puts columns side by side into a PointCloud2 of one row. */
class CloudBuilder
{
 public:
  explicit CloudBuilder(size_t points) : points_(points) {}

  template <class T>
  CloudBuilder& column(const std::string& name, uint8_t type, const std::vector<T>& values)
  {
    msgs::PointField field;
    field.name = name;
    field.datatype = type;
    field.count = 1;
    field.offset = step_;
    cloud_.fields.push_back(field);
    std::vector<std::string> bytes;
    bytes.reserve(values.size());
    for (const T value : values)
    {
      std::string one(sizeof(T), '\0');
      std::memcpy(one.data(), &value, sizeof(T));
      bytes.push_back(one);
    }
    columns_.push_back(std::move(bytes));
    step_ += sizeof(T);
    return *this;
  }

  /** `gap` unused bytes behind each point, `big` endian. */
  msgs::PointCloud2 build(uint32_t gap = 0, bool big = false)
  {
    cloud_.height = 1;
    cloud_.width = static_cast<uint32_t>(points_);
    cloud_.point_step = step_ + gap;
    cloud_.row_step = cloud_.point_step * cloud_.width;
    cloud_.is_bigendian = static_cast<uint8_t>(big);
    for (size_t i = 0; i < points_; ++i)
    {
      for (const auto& column : columns_)
      {
        std::string one = column.at(i);
        if (big)
        {
          std::reverse(one.begin(), one.end());
        }
        cloud_.data.insert(cloud_.data.end(), one.begin(), one.end());
      }
      cloud_.data.insert(cloud_.data.end(), gap, 0xee);
    }
    return cloud_;
  }

 private:
  size_t points_;
  uint32_t step_ = 0;
  msgs::PointCloud2 cloud_;
  std::vector<std::vector<std::string>> columns_;
};

/** A cloud as a Velodyne's driver publishes it: points on a circle of radius `range_m`. */
inline msgs::PointCloud2 velodyneCloud(double after_s, size_t points, float range_m)
{
  std::vector<float> x;
  std::vector<float> y;
  std::vector<float> z;
  std::vector<float> intensity;
  std::vector<uint16_t> ring;
  std::vector<float> time;
  for (size_t i = 0; i < points; ++i)
  {
    const float turn = 6.2832F * static_cast<float>(i) / static_cast<float>(points);
    x.push_back(range_m * std::cos(turn));
    y.push_back(range_m * std::sin(turn));
    z.push_back(-1.0F + 0.1F * static_cast<float>(i % 16));
    intensity.push_back(static_cast<float>(i % 256));
    ring.push_back(static_cast<uint16_t>(i % 16));
    time.push_back(-0.1F * static_cast<float>(i) / static_cast<float>(points));
  }
  using msgs::PointField;
  auto cloud = CloudBuilder(points)
                   .column("x", PointField::FLOAT32, x)
                   .column("y", PointField::FLOAT32, y)
                   .column("z", PointField::FLOAT32, z)
                   .column("intensity", PointField::FLOAT32, intensity)
                   .column("ring", PointField::UINT16, ring)
                   .column("time", PointField::FLOAT32, time)
                   .build();
  cloud.header = rosHeader(after_s, "velodyne");
  return cloud;
}

/** 181 rays from -90 to 90 degrees, counter-clockwise, all at `range_m`. */
inline msgs::LaserScan rosLaser(double after_s, float range_m)
{
  msgs::LaserScan scan;
  scan.header = rosHeader(after_s, "laser");
  scan.angle_min = -1.5707963F;
  scan.angle_max = 1.5707963F;
  scan.angle_increment = 3.1415927F / 180;
  scan.range_min = 0.1F;
  scan.range_max = 30.0F;
  scan.ranges.assign(181, range_m);
  return scan;
}

inline msgs::TransformStamped rosTransform(
    double after_s, const std::string& parent, const std::string& child, double x, double yaw)
{
  msgs::TransformStamped t;
  t.header = rosHeader(after_s, parent);
  t.child_frame_id = child;
  t.transform.translation.x = x;
  t.transform.rotation.z = std::sin(yaw / 2);
  t.transform.rotation.w = std::cos(yaw / 2);
  return t;
}

inline msgs::Odometry rosOdometry(double after_s, double x, double z)
{
  msgs::Odometry odometry;
  odometry.header = rosHeader(after_s, "odom");
  odometry.child_frame_id = "base_link";
  odometry.pose.pose.position.x = x;
  odometry.pose.pose.position.z = z;
  odometry.pose.pose.orientation.w = 1;
  for (size_t i = 0; i < 36; ++i)
  {
    odometry.pose.covariance[i] = static_cast<double>(i);
  }
  odometry.twist.twist.linear.x = 1.5;
  odometry.twist.twist.angular.z = 0.25;
  return odometry;
}

/** `bytes` per pixel of some encoding, all of one value. */
inline msgs::Image rosImage(
    double after_s, const std::string& frame, const std::string& encoding, const std::string& pixel)
{
  msgs::Image image;
  image.header = rosHeader(after_s, frame);
  image.width = 32;
  image.height = 24;
  image.encoding = encoding;
  image.step = image.width * static_cast<uint32_t>(pixel.size()) + 4;  // rows have a tail
  for (uint32_t row = 0; row < image.height; ++row)
  {
    for (uint32_t i = 0; i < image.width; ++i)
    {
      image.data.insert(image.data.end(), pixel.begin(), pixel.end());
    }
    image.data.insert(image.data.end(), 4, 0);
  }
  return image;
}

inline msgs::CameraInfo rosCamera(const std::string& frame)
{
  msgs::CameraInfo info;
  info.header = rosHeader(0, frame);
  info.width = 32;
  info.height = 24;
  info.distortion_model = "plumb_bob";
  info.D = {0.1, -0.2, 0.001, 0.002, 0.05};
  info.K = {30, 0, 16, 0, 31, 12, 0, 0, 1};
  info.P = {29, 0, 15, 0, 0, 28, 11, 0, 0, 0, 1, 0};
  return info;
}
}  // namespace traverse::testing
