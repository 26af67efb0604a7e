// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "channels_layout.h"

#include <traverse/formats/bytes.h>
#include <traverse/formats/checksum.h>
#include <traverse/formats/point_channels.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

namespace traverse::formats
{
namespace
{
constexpr size_t kMostClouds = 1U << 22U;  // bounds the index: 160 MB
constexpr float kLongestTime_s = 3600;

/** Up to n bytes; fewer where the file ends or cannot be read. */
std::string readAt(int fd, uint64_t at, size_t n)
{
  std::string bytes(n, '\0');
  size_t done = 0;
  while (done < n)
  {
    const ssize_t got = ::pread(fd, bytes.data() + done, n - done, static_cast<off_t>(at + done));
    if (got == 0 || (got < 0 && errno != EINTR))
    {
      break;
    }
    done += static_cast<size_t>(std::max<ssize_t>(got, 0));
  }
  bytes.resize(done);
  return bytes;
}

uint64_t hashOf(std::string_view label, int64_t stamp_ns)
{
  ByteWriter key;
  key.raw(label);
  key.i64(stamp_ns / channels::kTickNs);
  return std::hash<std::string_view>{}(key.bytes());
}

bool sane(const std::vector<float>& time_s)
{
  return std::all_of(
      time_s.begin(), time_s.end(), [](float t) { return std::abs(t) <= kLongestTime_s; });
}

template <class T>
void copyInto(std::vector<T>& to, std::string_view& from, size_t n)
{
  to.resize(n);
  if (n > 0)
  {
    std::memcpy(to.data(), from.data(), n * sizeof(T));
  }
  from.remove_prefix(n * sizeof(T));
}
}  // namespace

ChannelsReader::ChannelsReader(int fd) : fd_(fd)
{
  struct stat status = {};
  if (::fstat(fd, &status) != 0 || !S_ISREG(status.st_mode))
  {
    damage_ = "is no file that can be read";
    return;
  }
  size_ = static_cast<uint64_t>(status.st_size);
  const std::string prefix = readAt(fd, 0, channels::kPrefixBytes);
  if (prefix.substr(0, channels::kMagic.size()) != channels::kMagic ||
      prefix.size() < channels::kPrefixBytes)
  {
    damage_ = "is no file of point channels";
    return;
  }
  uint32_t version = 0;
  std::memcpy(&version, prefix.data() + channels::kMagic.size(), sizeof(version));
  if (version != channels::kVersion)
  {
    damage_ = fmt::format("has layout {}, only {} is known", version, channels::kVersion);
    return;
  }
  walk();
  std::sort(
      index_.begin(), index_.end(), [](const Place& a, const Place& b) { return a.key < b.key; });
}

void ChannelsReader::walk()
{
  uint64_t at = channels::kPrefixBytes;
  while (!readEnd(at))
  {
    const uint64_t began = at;
    const std::optional<Place> place = readHeader(at);
    if (!place)
    {
      damage_ = fmt::format("is damaged at byte {} of {}", began, size_);
      return;
    }
    if (index_.size() == kMostClouds)
    {
      damage_ = fmt::format("has more than {} clouds", kMostClouds);
      return;
    }
    index_.push_back(*place);
  }
}

bool ChannelsReader::readEnd(uint64_t at) const
{
  if (at + channels::kEndBytes != size_)
  {
    return false;
  }
  const std::string bytes = readAt(fd_, at, channels::kEndBytes);
  if (bytes.size() != channels::kEndBytes)
  {
    return false;
  }
  ByteReader in(bytes);
  const bool marked = in.u32() == channels::kEndMark;
  const bool counted = in.u64() == index_.size();
  return marked && counted && in.u32() == crc32(std::string_view(bytes).substr(0, 12));
}

std::optional<ChannelsReader::Place> ChannelsReader::readHeader(uint64_t& at) const
{
  // The longest header at once: one call for each cloud.
  const std::string bytes = readAt(fd_, at, channels::kHeadBytes + channels::kLongestLabel + 4);
  try
  {
    ByteReader in(bytes);
    Place place;
    const uint32_t mark = in.u32();
    place.flags = in.u32();
    const int64_t stamp_ns = in.i64();
    place.points = in.u32();
    place.checksum = in.u32();
    const std::string label = in.str(channels::kLongestLabel);
    const std::string_view head = std::string_view(bytes).substr(0, in.position());
    const bool good = in.u32() == crc32(head) && mark == channels::kCloudMark && place.flags > 0 &&
                      place.flags <= (channels::kRing | channels::kTime) &&
                      place.points <= channels::kMostPoints;
    place.payload = at + in.position();
    const uint64_t end =
        place.payload + channels::payloadBytes(place.flags, place.points) + sizeof(uint32_t);
    if (!good || end > size_)
    {
      return std::nullopt;
    }
    place.key = hashOf(label, stamp_ns);
    at = end;
    return place;
  }
  catch (const FormatError&)
  {
    return std::nullopt;
  }
}

ChannelsReader::Answer ChannelsReader::find(const CloudKey& key) const
{
  const uint64_t hash = hashOf(key.sensor_label, key.stamp_ns);
  auto place = std::lower_bound(
      index_.begin(), index_.end(), hash, [](const Place& p, uint64_t k) { return p.key < k; });
  Answer answer;
  for (; place != index_.end() && place->key == hash; ++place)
  {
    if (place->points == key.points && place->checksum == key.checksum)
    {
      return readPayload(*place);
    }
    answer.found = Found::another;
  }
  return answer;
}

ChannelsReader::Answer ChannelsReader::readPayload(const Place& place) const
{
  const size_t length = channels::payloadBytes(place.flags, place.points);
  const std::string bytes = readAt(fd_, place.payload, length + sizeof(uint32_t));
  Answer answer{Found::damaged, {}};
  if (bytes.size() != length + sizeof(uint32_t))
  {
    return answer;
  }
  std::string_view payload = std::string_view(bytes).substr(0, length);
  uint32_t crc = 0;
  std::memcpy(&crc, bytes.data() + length, sizeof(crc));
  if (crc != crc32(payload))
  {
    return answer;
  }
  copyInto(answer.channels.ring, payload, (place.flags & channels::kRing) != 0 ? place.points : 0);
  copyInto(
      answer.channels.time_s, payload, (place.flags & channels::kTime) != 0 ? place.points : 0);
  if (!sane(answer.channels.time_s))
  {
    return {Found::damaged, {}};
  }
  answer.found = Found::yes;
  return answer;
}
}  // namespace traverse::formats
