// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/gzip.h>

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>
#include <zlib.h>

namespace traverse::formats
{
namespace
{
constexpr int kGzipWindow = 15 + 16;  // zlib's way to ask for a gzip header
constexpr int kMemoryLevel = 8;

struct Stream
{
  z_stream z{};

  Stream()
  {
    if (deflateInit2(
            &z, Z_DEFAULT_COMPRESSION, Z_DEFLATED, kGzipWindow, kMemoryLevel, Z_DEFAULT_STRATEGY) !=
        Z_OK)
    {
      throw std::runtime_error("gzip: zlib does not start");
    }
  }

  ~Stream() { deflateEnd(&z); }

  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;
};
}  // namespace

std::string gzip(std::string_view bytes)
{
  Stream stream;
  std::string out;
  std::array<char, 1U << 16U> part{};
  int state = Z_OK;
  while (state != Z_STREAM_END)
  {
    // zlib counts in 32 bits: large inputs go in by pieces.
    const size_t piece = std::min<size_t>(bytes.size(), std::numeric_limits<uInt>::max());
    stream.z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.z.avail_in = static_cast<uInt>(piece);
    stream.z.next_out = reinterpret_cast<Bytef*>(part.data());
    stream.z.avail_out = part.size();
    state = deflate(&stream.z, piece == bytes.size() ? Z_FINISH : Z_NO_FLUSH);
    if (state == Z_STREAM_ERROR)
    {
      throw std::runtime_error("gzip: zlib cannot compress");
    }
    bytes.remove_prefix(piece - stream.z.avail_in);
    out.append(part.data(), part.size() - stream.z.avail_out);
  }
  return out;
}
}  // namespace traverse::formats
