// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "channels_layout.h"

#include <traverse/formats/bytes.h>
#include <traverse/formats/checksum.h>
#include <traverse/formats/point_channels.h>
#include <traverse/formats/streamed_file.h>

#include <stdexcept>

namespace traverse::formats
{
namespace
{
template <class T>
std::string_view bytesOf(std::span<const T> values)
{
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

void check(const CloudKey& key, const PointChannels& channels)
{
  const auto fits = [&](size_t n) { return n == 0 || n == key.points; };
  if (!fits(channels.ring.size()) || !fits(channels.time_s.size()))
  {
    throw std::invalid_argument("ChannelsWriter: channels of another length than their cloud");
  }
  if (key.sensor_label.size() > channels::kLongestLabel || key.points > channels::kMostPoints)
  {
    throw std::invalid_argument("ChannelsWriter: a label or a cloud too long");
  }
}
}  // namespace

struct ChannelsWriter::State
{
  explicit State(const std::filesystem::path& log) : file(channelsFileOf(log)) {}

  StreamedFile file;
};

uint32_t cloudChecksum(std::span<const float> x, std::span<const float> y, std::span<const float> z)
{
  ByteWriter sums;
  for (const auto& axis : {x, y, z})
  {
    sums.u64(axis.size());
    sums.u32(crc32(bytesOf(axis)));
  }
  return crc32(sums.bytes());
}

std::filesystem::path channelsFileOf(const std::filesystem::path& log)
{
  return log.string() + ".channels";
}

ChannelsWriter::ChannelsWriter(const std::filesystem::path& log) :
    state_(std::make_unique<State>(log))
{
  ByteWriter out;
  out.raw(channels::kMagic);
  out.u32(channels::kVersion);
  state_->file.write(out.bytes());
}

ChannelsWriter::~ChannelsWriter() = default;

void ChannelsWriter::add(const CloudKey& key, const PointChannels& channels)
{
  check(key, channels);
  if (channels.empty())
  {
    return;
  }
  ByteWriter out;
  out.u32(channels::kCloudMark);
  out.u32(
      (channels.ring.empty() ? 0 : channels::kRing) |
      (channels.time_s.empty() ? 0 : channels::kTime));
  out.i64(key.stamp_ns);
  out.u32(key.points);
  out.u32(key.checksum);
  out.str(key.sensor_label);
  out.u32(crc32(out.bytes()));
  ByteWriter payload;
  payload.raw(bytesOf(std::span<const uint16_t>(channels.ring)));
  payload.raw(bytesOf(std::span<const float>(channels.time_s)));
  payload.u32(crc32(payload.bytes()));
  out.raw(payload.bytes());
  state_->file.write(out.bytes());
  ++clouds_;
}

void ChannelsWriter::finish()
{
  ByteWriter out;
  out.u32(channels::kEndMark);
  out.u64(clouds_);
  out.u32(crc32(out.bytes()));
  state_->file.write(out.bytes());
  state_->file.finish();
}

void ChannelsWriter::commit()
{
  state_->file.commit();
}
}  // namespace traverse::formats
