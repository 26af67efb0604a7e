// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/sandbox/frame_stream.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <unistd.h>

namespace traverse::sandbox
{
FrameStream::FrameStream(
    int input_fd, const ReaderLimits& limits, const ReaderJob& job, const std::atomic<bool>* stop) :
    stop_(stop), process_(input_fd, limits, job)
{
}

std::optional<Frame> FrameStream::next()
{
  while (!frameComplete())
  {
    if (!receiveMore())
    {
      return std::nullopt;
    }
  }
  return takeFrame();
}

bool FrameStream::frameComplete() const
{
  FrameHeader header;
  const size_t there = received_.size() - used_;
  if (there < sizeof(header))
  {
    return false;
  }
  std::memcpy(&header, received_.data() + used_, sizeof(header));
  if (header.magic != FrameHeader::kMagic || header.length > FrameHeader::kLongest)
  {
    throw ReaderFailure("the reader spoke nonsense: a frame without its mark, or of absurd length");
  }
  return there >= sizeof(header) + header.length;
}

Frame FrameStream::takeFrame()
{
  FrameHeader header;
  std::memcpy(&header, received_.data() + used_, sizeof(header));
  const uint8_t* payload = received_.data() + used_ + sizeof(header);
  used_ += sizeof(header) + header.length;
  return {header.type, {payload, static_cast<size_t>(header.length)}};
}

/** False once the child has left in an orderly way. */
bool FrameStream::receiveMore()
{
  if (stop_ != nullptr && *stop_)
  {
    throw ReaderStopped();
  }
  const std::string misbehaviour = process_.misbehaviour();
  if (!misbehaviour.empty())
  {
    throw ReaderFailure(misbehaviour);
  }
  received_.erase(received_.begin(), received_.begin() + static_cast<std::ptrdiff_t>(used_));
  used_ = 0;
  process_.wait();
  if (process_.receive(received_))
  {
    return true;
  }
  const std::string how = process_.finish();
  if (!how.empty())
  {
    throw ReaderFailure(how);
  }
  return false;
}

void writeAll(int frames_fd, std::span<const uint8_t> bytes)
{
  while (!bytes.empty())
  {
    const ssize_t some = ::write(frames_fd, bytes.data(), bytes.size());
    if (some < 0 && errno != EINTR)
    {
      throw std::system_error(errno, std::generic_category(), "the reader's pipe");
    }
    bytes = bytes.subspan(some > 0 ? static_cast<size_t>(some) : 0);
  }
}
}  // namespace traverse::sandbox
