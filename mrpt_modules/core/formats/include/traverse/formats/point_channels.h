// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace traverse::formats
{
/** What no cloud class of MRPT 2.5.8 can carry, per point of a cloud, in its order: each of the
 * cloud's length, or empty where the sensor has none. */
struct PointChannels
{
  std::vector<uint16_t> ring;  //!< laser, as the recording numbers it
  std::vector<float> time_s;   //!< of the point, relative to the observation's stamp

  bool empty() const { return ring.empty() && time_s.empty(); }

  friend bool operator==(const PointChannels&, const PointChannels&) = default;
};

/** Which cloud of a log channels belong to. */
struct CloudKey
{
  std::string_view sensor_label;
  int64_t stamp_ns = 0;   //!< since 1970; compared to 100 ns, the resolution of a rawlog
  uint32_t points = 0;    //!< of the cloud, also those that are no points (NaN, 0 0 0)
  uint32_t checksum = 0;  //!< cloudChecksum() of it
};

/** Tells clouds apart: a log that was edited no longer fits its channels. */
uint32_t cloudChecksum(
    std::span<const float> x, std::span<const float> y, std::span<const float> z);

/** Where the channels of a log are: `some.rawlog.channels`. */
std::filesystem::path channelsFileOf(const std::filesystem::path& log);

/** Writes the channels of a log beside it, cloud by cloud, in any order.
 *
 * Layout, little-endian:
 *
 *     8   magic 89 54 52 43 48 0D 0A 1A    (\x89 "TRCH" \r \n \x1a)
 *     u32 version of this layout           (1)
 *     each cloud: u32 mark "CLUD", u32 flags (1 ring, 2 time), i64 stamp ns, u32 points,
 *                 u32 checksum of the cloud, u32 length of the label (at most 1024), label,
 *                 u32 CRC-32 of all that from the mark on
 *                 ring: u16 per point, time: f32 per point (those that the flags name),
 *                 u32 CRC-32 of these
 *     at the end: u32 mark "CEND", u64 number of clouds, u32 CRC-32 of these 12 bytes */
class ChannelsWriter
{
 public:
  /** Writes to <channelsFileOf(log)>.partial. Throws FileError. */
  explicit ChannelsWriter(const std::filesystem::path& log);
  ~ChannelsWriter();
  ChannelsWriter(const ChannelsWriter&) = delete;
  ChannelsWriter& operator=(const ChannelsWriter&) = delete;

  /** Clouds with empty channels are left out. Throws std::invalid_argument where the channels are
   * not of the cloud's length, FileError where the disk refuses. */
  void add(const CloudKey& key, const PointChannels& channels);

  /** Clouds so far. */
  uint64_t clouds() const { return clouds_; }

  /** All is on the disk, not yet under its name. Throws FileError. */
  void finish();

  /** After finish(): under its name. Throws FileError. */
  void commit();

 private:
  struct State;
  std::unique_ptr<State> state_;
  uint64_t clouds_ = 0;
};

/** Finds the channels of clouds; the file may be hostile, and is read from an open descriptor that
 * stays the caller's. */
class ChannelsReader
{
 public:
  enum class Found : uint8_t
  {
    yes,
    none,     //!< the file has nothing for this label and stamp
    another,  //!< it has, but of another cloud
    damaged,  //!< it has, but broken
  };

  struct Answer
  {
    Found found = Found::none;
    PointChannels channels;
  };

  /** Walks the file. What can be read is; damage() says what cannot. */
  explicit ChannelsReader(int fd);

  /** The file's clouds that can be found. */
  size_t clouds() const { return index_.size(); }

  /** Why part of the file is lost; empty where it is whole. */
  const std::string& damage() const { return damage_; }

  /** Reads one cloud's channels; times are finite and within an hour. */
  Answer find(const CloudKey& key) const;

 private:
  struct Place
  {
    uint64_t key = 0;  // hash of label and stamp
    uint64_t payload = 0;
    uint32_t points = 0;
    uint32_t checksum = 0;
    uint32_t flags = 0;
  };

  void walk();
  std::optional<Place> readHeader(uint64_t& at) const;
  bool readEnd(uint64_t at) const;
  Answer readPayload(const Place& place) const;

  int fd_;
  uint64_t size_ = 0;
  std::vector<Place> index_;  // sorted by key
  std::string damage_;
};
}  // namespace traverse::formats
