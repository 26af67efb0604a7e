// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/ros_bags/open_bag.h>

#include <rosbag/bag.h>
#include <support/ros_messages.h>
#include <support/scratch_folder.h>

namespace traverse::testing
{
/** A bag that ROS's own library writes. */
class BagFile
{
 public:
  explicit BagFile(
      rosbag::CompressionType compression = rosbag::compression::Uncompressed,
      uint32_t chunk_bytes = 768 * 1024)
  {
    bag_.open(path().string(), rosbag::bagmode::Write);
    bag_.setCompression(compression);
    bag_.setChunkThreshold(chunk_bytes);
  }

  std::filesystem::path path() const { return dir_ / "recording.bag"; }

  template <class M>
  void write(const std::string& topic, double recorded_after_s, const M& message)
  {
    bag_.write(topic, rosTime(recorded_after_s), message);
  }

  void writeTf(const msgs::TransformStamped& transform, bool fixed = true)
  {
    msgs::TFMessage message;
    message.transforms.push_back(transform);
    bag_.write(fixed ? "/tf_static" : "/tf", transform.header.stamp, message);
  }

  /** Nothing more comes; its bytes. */
  std::string bytes()
  {
    bag_.close();
    return readText(path());
  }

 private:
  ScratchFolder dir_;
  rosbag::Bag bag_;
};

struct BagReading
{
  std::vector<importing::Entry> entries;
  importing::ImportReport report;
};

inline BagReading readBag(const std::filesystem::path& file, const ros_bags::BagParams& params = {})
{
  const auto source = ros_bags::openBag(file, params);
  BagReading reading;
  while (auto entry = source->next())
  {
    reading.entries.push_back(std::move(*entry));
  }
  reading.report = source->report();
  return reading;
}

inline BagReading readBag(BagFile& bag, const ros_bags::BagParams& params = {})
{
  bag.bytes();
  return readBag(bag.path(), params);
}

/** The n-th observation of a class. */
template <class T>
std::shared_ptr<T> observationOf(const BagReading& reading, size_t n = 0)
{
  for (const importing::Entry& entry : reading.entries)
  {
    auto found = std::dynamic_pointer_cast<T>(entry.observation);
    if (found && n-- == 0)
    {
      return found;
    }
  }
  throw std::runtime_error("no such observation");
}
}  // namespace traverse::testing
