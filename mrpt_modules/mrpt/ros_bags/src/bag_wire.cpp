// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bag_wire.h"

#include <traverse/formats/bytes.h>

namespace traverse::ros_bags
{
namespace
{
constexpr size_t kLongestText = 1024;

/** Names out of a bag may be of any length. */
std::string_view shortened(const std::string& text)
{
  return std::string_view(text).substr(0, kLongestText);
}

struct Put
{
  formats::ByteWriter& out;

  void operator()(const BagOpened& news) const { out.u64(news.messages); }

  void operator()(const BagMessage& news) const
  {
    out.str(shortened(news.topic));
    out.str(shortened(news.type));
    out.str(shortened(news.md5sum));
    out.i64(news.recorded_ns);
    out.raw(news.bytes);
  }

  void operator()(const BagSkipped& news) const
  {
    out.str(shortened(news.topic));
    out.str(shortened(news.type));
  }

  void operator()(const BagUnreadable& news) const
  {
    out.str(shortened(news.topic));
    out.str(shortened(news.type));
    out.str(shortened(news.why));
  }

  void operator()(const BagFailed& news) const { out.str(shortened(news.why)); }

  void operator()(const BagEnd&) const {}
};

BagMessage readMessage(formats::ByteReader& in)
{
  BagMessage message;
  message.topic = in.str(kLongestText);
  message.type = in.str(kLongestText);
  message.md5sum = in.str(kLongestText);
  message.recorded_ns = in.i64();
  message.bytes = in.raw(in.remaining());
  return message;
}

BagNews readPayload(formats::ByteReader& in, uint32_t type)
{
  switch (type)
  {
    case 0:
      return BagOpened{in.u64()};
    case 1:
      return readMessage(in);
    case 2:
    {
      std::string topic = in.str(kLongestText);
      return BagSkipped{std::move(topic), in.str(kLongestText)};
    }
    case 3:
    {
      std::string topic = in.str(kLongestText);
      std::string type = in.str(kLongestText);
      return BagUnreadable{std::move(topic), std::move(type), in.str(kLongestText)};
    }
    case 4:
      return BagFailed{in.str(kLongestText)};
    case 5:
      return BagEnd{};
    default:
      in.fail("a frame of an unknown kind");
  }
}
}  // namespace

void send(int frames_fd, const BagNews& news)
{
  // The index in the variant is the frame's type.
  formats::ByteWriter out;
  sandbox::FrameHeader header;
  header.type = static_cast<uint32_t>(news.index());
  out.raw({reinterpret_cast<const char*>(&header), sizeof(header)});
  std::visit(Put{out}, news);
  std::string bytes = out.take();
  header.length = bytes.size() - sizeof(header);
  std::memcpy(bytes.data(), &header, sizeof(header));
  sandbox::writeAll(frames_fd, {reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size()});
}

BagNews readNews(const sandbox::Frame& frame)
{
  formats::ByteReader in(
      {reinterpret_cast<const char*>(frame.payload.data()), frame.payload.size()},
      "the bag's reader");
  BagNews news = readPayload(in, frame.type);
  in.expectEnd();
  return news;
}
}  // namespace traverse::ros_bags
