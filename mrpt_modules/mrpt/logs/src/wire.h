// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/points/decoded.h>
#include <traverse/poses/pose_track.h>
#include <traverse/sandbox/frame_stream.h>

#include <cstring>
#include <span>
#include <string>
#include <vector>

// What the frames of a log's child hold (sandbox/frame_stream.h). The parent trusts none of it.
namespace traverse::logs
{
enum class FrameType : uint32_t
{
  scan = 1,
  count = 2,
  pose = 3,
  object = 4,  //!< one more entry of the log is done
  damage = 5,
  end = 6,
  sighting = 7,
};

using sandbox::FrameHeader;
using sandbox::WireError;

/** What is counted by class. */
enum class Counted : uint8_t
{
  delivered,
  ignored,
  rejected,
  repeated_stamp,
  backward_stamp,
  bad_stamp,
  channels,         //!< `reason`: what became of a cloud's ring and time
  channels_damage,  //!< `reason`: what is wrong with the file of them
  note,             //!< no count: `reason` is what is to be known about `type`
};

struct CountFrame
{
  Counted what = Counted::ignored;
  std::string type;
  std::string reason;
};

struct DamageFrame
{
  bool not_a_log = false;
  std::string message;
};

/** An observation was met, whatever becomes of it. */
struct SightingFrame
{
  std::string label;
  std::string type;
  poses::TimeNs stamp = 0;  //!< 0: no clock's
  Eigen::Isometry3d T_base_sensor = Eigen::Isometry3d::Identity();
};

/** Puts frames one behind the other. */
class FrameWriter
{
 public:
  void add(const points::Decoded& decoded);
  void add(const CountFrame& count);
  void add(const poses::StampedPose& pose);
  void add(const DamageFrame& damage);
  void add(const SightingFrame& sighting);
  void add(FrameType bare);

  std::vector<uint8_t>& bytes() { return bytes_; }

 private:
  template <class T>
  void put(const T& value)
  {
    const auto* from = reinterpret_cast<const uint8_t*>(&value);
    bytes_.insert(bytes_.end(), from, from + sizeof(T));
  }

  template <class T>
  void put(const std::vector<T>& values)
  {
    put(uint64_t{values.size()});
    const auto* from = reinterpret_cast<const uint8_t*>(values.data());
    bytes_.insert(bytes_.end(), from, from + values.size() * sizeof(T));
  }

  void put(const std::string& text);
  void put(const Eigen::Isometry3d& pose);
  size_t begin(FrameType type);
  void finish(size_t start);

  std::vector<uint8_t> bytes_;
};

// Each throws WireError where the payload is not exactly one such thing, and consistent.
points::Decoded readScan(std::span<const uint8_t> payload);
CountFrame readCount(std::span<const uint8_t> payload);
poses::StampedPose readPose(std::span<const uint8_t> payload);
DamageFrame readDamage(std::span<const uint8_t> payload);
SightingFrame readSighting(std::span<const uint8_t> payload);
}  // namespace traverse::logs
