// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bag_job.h"

#include <console_bridge/console.h>
#include <memory>
#include <new>
#include <ros/serialization.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <vector>

namespace traverse::ros_bags
{
namespace
{
constexpr uint32_t kLongestMessage = 1U << 29U;

bool wanted(const std::string& topic, const std::string& type, const BagSelection& want)
{
  return want.types.count(type) > 0 && (want.topics.empty() || want.topics.count(topic) > 0);
}

void sendMessage(
    const rosbag::MessageInstance& message, int frames_fd, std::vector<uint8_t>& buffer)
{
  const uint32_t size = message.size();
  if (size > kLongestMessage)
  {
    throw rosbag::BagFormatException("a message of " + std::to_string(size) + " bytes");
  }
  buffer.resize(size);
  ros::serialization::OStream stream(buffer.data(), size);
  message.write(stream);
  BagMessage news;
  news.topic = message.getTopic();
  news.type = message.getDataType();
  news.md5sum = message.getMD5Sum();
  constexpr int64_t kNsPerS = 1'000'000'000;
  news.recorded_ns = message.getTime().sec * kNsPerS + message.getTime().nsec;
  news.bytes = {reinterpret_cast<const char*>(buffer.data()), size};
  send(frames_fd, news);
}

/** One message; what is wrong with it is told and does not end the pass. */
void handle(
    const rosbag::MessageInstance& message,
    int frames_fd,
    std::vector<uint8_t>& buffer,
    const BagSelection& want)
{
  if (!wanted(message.getTopic(), message.getDataType(), want))
  {
    send(frames_fd, BagSkipped{message.getTopic(), message.getDataType()});
    return;
  }
  std::string why;
  try
  {
    sendMessage(message, frames_fd, buffer);
    return;
  }
  catch (const ros::Exception& e)
  {
    why = e.what();
  }
  catch (const std::bad_alloc&)
  {
    why = "it needs more memory than reader_memory_mb";
  }
  send(frames_fd, BagUnreadable{message.getTopic(), message.getDataType(), why});
}

void readAll(
    const rosbag::Bag& bag,
    int frames_fd,
    sandbox::SharedProgress& progress,
    const BagSelection& want)
{
  rosbag::View view(
      bag, [&](const rosbag::ConnectionInfo* c)
      { return want.name_others || wanted(c->topic, c->datatype, want); });
  send(frames_fd, BagOpened{view.size()});
  std::vector<uint8_t> buffer;
  uint64_t i = 0;
  for (auto it = view.begin(); it != view.end(); ++it, ++i)
  {
    progress.object = i;
    if (i >= want.first)
    {
      handle(*it, frames_fd, buffer, want);
    }
  }
  send(frames_fd, BagEnd{});
}
}  // namespace

void runBagJob(
    int bag_fd, int frames_fd, sandbox::SharedProgress& progress, const BagSelection& want)
{
  console_bridge::noOutputHandler();
  std::string why;
  try
  {
    // Never destroyed: the process ends behind this, and a bag that is broken may break there.
    auto bag = std::make_unique<rosbag::Bag>();
    bag->open("/proc/self/fd/" + std::to_string(bag_fd), rosbag::bagmode::Read);
    readAll(*bag.release(), frames_fd, progress, want);
    return;
  }
  catch (const rosbag::BagUnindexedException&)
  {
    why = "has no index: its recording was cut off; `rosbag reindex` makes one";
  }
  catch (const std::bad_alloc&)
  {
    why = "reading it needs more memory than reader_memory_mb";
  }
  catch (const std::exception& e)
  {
    why = e.what();
  }
  send(frames_fd, BagFailed{why});
}
}  // namespace traverse::ros_bags
