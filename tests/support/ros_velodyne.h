// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <support/ros_messages.h>
#include <vector>

namespace traverse::testing::msgs
{
/** velodyne_msgs/VelodyneScan, which Debian does not have. */
struct VelodyneScan
{
  struct Packet
  {
    ros::Time stamp;
    std::array<uint8_t, 1206> data{};
  };

  Header header;
  std::vector<Packet> packets;
};
}  // namespace traverse::testing::msgs

namespace ros
{
namespace message_traits
{
template <>
struct MD5Sum<traverse::testing::msgs::VelodyneScan>
{
  static const char* value(const traverse::testing::msgs::VelodyneScan& /*m*/)
  {
    return "50804fc9533a0e579e6322c04ae70566";
  }
};

template <>
struct DataType<traverse::testing::msgs::VelodyneScan>
{
  static const char* value(const traverse::testing::msgs::VelodyneScan& /*m*/)
  {
    return "velodyne_msgs/VelodyneScan";
  }
};

template <>
struct Definition<traverse::testing::msgs::VelodyneScan>
{
  static const char* value(const traverse::testing::msgs::VelodyneScan& /*m*/)
  {
    return "Header header\nVelodynePacket[] packets\n";
  }
};
}  // namespace message_traits

namespace serialization
{
template <>
struct Serializer<traverse::testing::msgs::VelodyneScan>
{
  template <class Stream>
  static void write(Stream& stream, const traverse::testing::msgs::VelodyneScan& m)
  {
    stream.next(m.header);
    stream.next(static_cast<uint32_t>(m.packets.size()));
    for (const auto& packet : m.packets)
    {
      stream.next(packet.stamp);
      std::copy(packet.data.begin(), packet.data.end(), stream.advance(1206));
    }
  }

  static uint32_t serializedLength(const traverse::testing::msgs::VelodyneScan& m)
  {
    return serializationLength(m.header) + 4 + static_cast<uint32_t>(m.packets.size()) * 1214;
  }
};
}  // namespace serialization
}  // namespace ros
