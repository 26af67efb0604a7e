// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/sandbox/frame_stream.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

// What the child that reads a bag says to its parent.
namespace traverse::ros_bags
{
/** The bag is open. */
struct BagOpened
{
  uint64_t messages = 0;  //!< that this pass will come to
};

/** A message as it was recorded; `bytes` looks into the frame. */
struct BagMessage
{
  std::string topic, type, md5sum;
  int64_t recorded_ns = 0;
  std::string_view bytes;
};

/** A message whose bytes were not asked for. */
struct BagSkipped
{
  std::string topic, type;
};

/** A message that could not be read. */
struct BagUnreadable
{
  std::string topic, type, why;
};

/** The bag could not be opened, or not read to its end. */
struct BagFailed
{
  std::string why;
};

struct BagEnd
{
};

using BagNews = std::variant<BagOpened, BagMessage, BagSkipped, BagUnreadable, BagFailed, BagEnd>;

void send(int frames_fd, const BagNews& news);

/** Throws formats::FormatError where the frame is none of them. */
BagNews readNews(const sandbox::Frame& frame);
}  // namespace traverse::ros_bags
