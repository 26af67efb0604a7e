// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/bytes.h>
#include <traverse/formats/gzip.h>

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <limits>
#include <stdexcept>
#include <zlib.h>

namespace traverse::formats
{
namespace
{
constexpr int kGzipWindow = 15 + 16;  // zlib's way to ask for a gzip header
constexpr int kMemoryLevel = 8;
constexpr size_t kPart = 1U << 16U;

/** Counts in 32 bits: large inputs go in by pieces. */
size_t feed(z_stream& z, std::string_view bytes)
{
  const size_t piece = std::min<size_t>(bytes.size(), std::numeric_limits<uInt>::max());
  z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  z.avail_in = static_cast<uInt>(piece);
  return piece;
}

struct Inflater
{
  z_stream z{};

  Inflater()
  {
    if (inflateInit2(&z, kGzipWindow) != Z_OK)
    {
      throw std::runtime_error("gzip: zlib does not start");
    }
  }

  ~Inflater() { inflateEnd(&z); }

  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  /** Takes one member off the bytes and appends what it holds. */
  void member(std::string_view& bytes, std::string& out, size_t max_bytes)
  {
    std::array<char, kPart> part{};
    int state = Z_OK;
    while (state != Z_STREAM_END)
    {
      const size_t piece = feed(z, bytes);
      z.next_out = reinterpret_cast<Bytef*>(part.data());
      z.avail_out = part.size();
      state = inflate(&z, Z_NO_FLUSH);
      if (state != Z_OK && state != Z_STREAM_END)
      {
        throw FormatError(state == Z_BUF_ERROR ? "gzip: cut short" : "gzip: damaged");
      }
      bytes.remove_prefix(piece - z.avail_in);
      out.append(part.data(), part.size() - z.avail_out);
      if (out.size() > max_bytes)
      {
        throw FormatError(fmt::format("gzip: holds more than the {} bytes allowed", max_bytes));
      }
    }
    inflateReset(&z);
  }
};
}  // namespace

struct GzipStream::State
{
  z_stream z{};
};

GzipStream::GzipStream() : state_(std::make_unique<State>())
{
  if (deflateInit2(
          &state_->z, Z_DEFAULT_COMPRESSION, Z_DEFLATED, kGzipWindow, kMemoryLevel,
          Z_DEFAULT_STRATEGY) != Z_OK)
  {
    throw std::runtime_error("gzip: zlib does not start");
  }
}

GzipStream::~GzipStream()
{
  deflateEnd(&state_->z);
}

std::string GzipStream::add(std::string_view bytes)
{
  z_stream& z = state_->z;
  std::string out;
  std::array<char, kPart> part{};
  while (!bytes.empty())
  {
    const size_t piece = feed(z, bytes);
    z.next_out = reinterpret_cast<Bytef*>(part.data());
    z.avail_out = part.size();
    if (deflate(&z, Z_NO_FLUSH) == Z_STREAM_ERROR)
    {
      throw std::runtime_error("gzip: zlib cannot compress");
    }
    bytes.remove_prefix(piece - z.avail_in);
    out.append(part.data(), part.size() - z.avail_out);
  }
  return out;
}

std::string GzipStream::finish()
{
  z_stream& z = state_->z;
  std::string out;
  std::array<char, kPart> part{};
  feed(z, {});
  int state = Z_OK;
  while (state != Z_STREAM_END)
  {
    z.next_out = reinterpret_cast<Bytef*>(part.data());
    z.avail_out = part.size();
    state = deflate(&z, Z_FINISH);
    if (state == Z_STREAM_ERROR)
    {
      throw std::runtime_error("gzip: zlib cannot compress");
    }
    out.append(part.data(), part.size() - z.avail_out);
  }
  return out;
}

std::string gzip(std::string_view bytes)
{
  GzipStream stream;
  std::string out = stream.add(bytes);
  out += stream.finish();
  return out;
}

bool isGzip(std::string_view bytes)
{
  return bytes.substr(0, 2) == "\x1f\x8b";
}

std::string gunzip(std::string_view bytes, size_t max_bytes)
{
  Inflater inflater;
  std::string out;
  do
  {
    inflater.member(bytes, out, max_bytes);
  } while (!bytes.empty());
  return out;
}
}  // namespace traverse::formats
