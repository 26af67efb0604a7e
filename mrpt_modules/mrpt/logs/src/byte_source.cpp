// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "byte_source.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>
#include <new>
#include <system_error>
#include <unistd.h>

namespace traverse::logs
{
namespace
{
constexpr size_t kChunk = 1U << 16U;
constexpr int kGzip = 16 + MAX_WBITS;

bool isGzip(const std::vector<uint8_t>& bytes, size_t at)
{
  return bytes.size() - at >= 2 && bytes[at] == 0x1f && bytes[at + 1] == 0x8b;
}
}  // namespace

ByteSource::ByteSource(int fd) : fd_(fd)
{
  refill();
  compressed_ = isGzip(input_, 0);
  if (compressed_ && inflateInit2(&zlib_, kGzip) != Z_OK)
  {
    throw std::bad_alloc();
  }
}

ByteSource::~ByteSource()
{
  if (compressed_)
  {
    inflateEnd(&zlib_);
  }
}

bool ByteSource::refill()
{
  input_.erase(input_.begin(), input_.begin() + static_cast<std::ptrdiff_t>(used_));
  used_ = 0;
  const size_t kept = input_.size();
  input_.resize(kept + kChunk);
  ssize_t got = 0;
  do
  {
    got = ::pread(fd_, input_.data() + kept, kChunk, static_cast<off_t>(offset_));
  } while (got < 0 && errno == EINTR);
  if (got < 0)
  {
    damage_ = "reading the file failed: " + std::generic_category().message(errno);
  }
  const size_t more = got > 0 ? static_cast<size_t>(got) : 0;
  input_.resize(kept + more);
  offset_ += more;
  return more > 0;
}

size_t ByteSource::read(void* buffer, size_t n)
{
  auto* to = static_cast<uint8_t*>(buffer);
  size_t done = 0;
  while (done < n && !ended_ && damage_.empty())
  {
    done += compressed_ ? inflateSome(to + done, n - done) : readPlain(to + done, n - done);
  }
  return done;
}

size_t ByteSource::readPlain(uint8_t* to, size_t n)
{
  if (used_ == input_.size() && !refill())
  {
    ended_ = true;
    return 0;
  }
  const size_t some = std::min(n, input_.size() - used_);
  std::memcpy(to, input_.data() + used_, some);
  used_ += some;
  return some;
}

size_t ByteSource::inflateSome(uint8_t* to, size_t n)
{
  if (used_ == input_.size() && !refill())
  {
    damage_ = damage_.empty() ? "the gzip data are cut short" : damage_;
    return 0;
  }
  zlib_.next_in = input_.data() + used_;
  zlib_.avail_in = static_cast<uInt>(input_.size() - used_);
  zlib_.next_out = to;
  zlib_.avail_out = static_cast<uInt>(std::min<size_t>(n, std::numeric_limits<uInt>::max()));
  const uInt room = zlib_.avail_out;
  const int status = inflate(&zlib_, Z_NO_FLUSH);
  used_ = input_.size() - zlib_.avail_in;
  const size_t got = room - zlib_.avail_out;
  if (status == Z_STREAM_END)
  {
    ended_ = !nextMember();
  }
  else if (status == Z_MEM_ERROR)
  {
    throw std::bad_alloc();
  }
  else if (status != Z_OK && status != Z_BUF_ERROR)
  {
    damage_ = std::string("the gzip data are corrupt (") +
              (zlib_.msg != nullptr ? zlib_.msg : "no reason given") + ")";
  }
  return got;
}

bool ByteSource::nextMember()
{
  if (input_.size() - used_ < 2)
  {
    refill();
  }
  if (used_ == input_.size())
  {
    return false;
  }
  if (isGzip(input_, used_))
  {
    return inflateReset(&zlib_) == Z_OK;
  }
  damage_ = "something that is no gzip data follows the log";
  return false;
}
}  // namespace traverse::logs
