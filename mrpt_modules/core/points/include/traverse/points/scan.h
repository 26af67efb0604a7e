// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/poses/pose_track.h>

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace traverse::points
{
using poses::TimeNs;
struct RangeImage;

/** Why a value of an observation did not become a point. */
enum class Reject : uint8_t
{
  no_return,     //!< the beam met nothing within range
  nonfinite,     //!< NaN or Inf
  flagged,       //!< the sensor marked it as bad
  below_range,   //!< nearer than the sensor's (or the ini's) shortest range
  beyond_range,  //!< further than the longest range
  bad_packet,    //!< a packet that is none of this sensor's
  excluded,      //!< by the ini, e.g. on the vehicle's own body
};

inline constexpr size_t kRejectCount = 7;
inline constexpr std::array<std::string_view, kRejectCount> kRejectNames = {
    "no_return", "nonfinite", "flagged", "below_range", "beyond_range", "bad_packet", "excluded"};

/** Number of values left out, by reason. */
struct RejectCounts
{
  std::array<uint64_t, kRejectCount> count{};

  void add(Reject reason, uint64_t n = 1) { count[static_cast<size_t>(reason)] += n; }

  uint64_t of(Reject reason) const { return count[static_cast<size_t>(reason)]; }

  void operator+=(const RejectCounts& other)
  {
    for (size_t i = 0; i < kRejectCount; ++i)
    {
      count[i] += other.count[i];
    }
  }
};

/** What one observation measured, as points; a view that owns nothing.
 *
 * x, y, z in the vehicle frame, metres, all finite. time_s, ring, intensity and rgb have the length
 * of x or are empty (the sensor has none). Before deskew() a point lies in the vehicle frame of its
 * own time, after it in that of `stamp`. */
struct Scan
{
  TimeNs stamp = 0;               //!< reference time of the scan
  std::string_view sensor_label;  //!< as in the log; untrusted text
  Eigen::Isometry3d T_base_sensor = Eigen::Isometry3d::Identity();  //!< NaN: from no one place
  std::span<const float> x, y, z;
  std::span<const float> time_s;     //!< of the point, relative to `stamp`
  std::span<const uint16_t> ring;    //!< laser or row, 0 = lowest elevation
  std::span<const float> intensity;  //!< 0..1
  std::span<const uint32_t> rgb;     //!< 0x00RRGGBB

  /** The same observation with the beams that met nothing (points/range_image.h), as measured: it
   * is never deskewed. nullptr: not known. */
  const RangeImage* image = nullptr;

  size_t size() const { return x.size(); }
};

/** The storage behind a Scan. */
struct ScanBuffer
{
  TimeNs stamp = 0;
  std::string sensor_label;
  Eigen::Isometry3d T_base_sensor = Eigen::Isometry3d::Identity();
  std::vector<float> x, y, z, time_s;
  std::vector<uint16_t> ring;
  std::vector<float> intensity;
  std::vector<uint32_t> rgb;

  /** Which point of the observation's own cloud each point is; empty: the same, none was left out.
   */
  std::vector<uint32_t> input_index;
  uint32_t input_points = 0;  //!< of that cloud, where input_index is not empty

  Scan view() const;

  size_t size() const { return x.size(); }

  void reserve(size_t n);
};
}  // namespace traverse::points
