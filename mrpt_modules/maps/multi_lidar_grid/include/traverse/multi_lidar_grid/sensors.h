// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/multi_lidar_grid/clock_offset.h>
#include <traverse/multi_lidar_grid/params.h>
#include <traverse/multi_lidar_grid/unit_map.h>
#include <traverse/poses/pose_track.h>

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace traverse::multi_lidar_grid
{
/** How a sensor is. */
enum class Health : uint8_t
{
  ok,     //!< clouds come as usual
  late,   //!< the next one is overdue by twice the usual time between them
  stale,  //!< silent for longer than its time-out: its latest cloud no longer counts
  dead,   //!< silent for ten time-outs
  stuck,  //!< it sends the same cloud again and again
};

std::string_view nameOf(Health health);

/** One sensor, as the map knows it. */
struct Sensor
{
  std::string label;
  UnitMap latest;             //!< its latest cloud
  bool has_cloud = false;     //!< latest is of a cloud
  poses::TimeNs newest = 0;   //!< stamp of its newest cloud, in the poses' time
  double period_s = 0;        //!< usual time between clouds; 0: not known
  uint64_t clouds = 0;        //!< taken
  uint64_t refused_late = 0;  //!< later than order_window_s
  uint64_t last_hash = 0;     //!< of the newest cloud's points
  uint32_t repeats = 0;       //!< clouds in a row with that hash
  ClockOffset clock;
  double clock_offset_s = 0;  //!< in use
};

/** The sensors in the order of their first cloud, which is their bit's. The 32nd bit stands for all
 * from the 32nd on, which share one unit map. */
class Sensors
{
 public:
  static constexpr size_t kMost = 32;

  /** The sensor of a label, made where it is new. */
  Sensor& obtain(std::string_view label, int32_t region_edge);

  uint32_t bitOf(const Sensor& sensor) const;

  Health healthOf(const Sensor& sensor, poses::TimeNs now, const Params& params) const;

  const std::deque<Sensor>& all() const { return sensors_; }

  std::deque<Sensor>& all() { return sensors_; }

 private:
  std::deque<Sensor> sensors_;
};
}  // namespace traverse::multi_lidar_grid
