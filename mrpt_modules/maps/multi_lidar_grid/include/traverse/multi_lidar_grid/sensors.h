// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/multi_lidar_grid/clock_offset.h>
#include <traverse/multi_lidar_grid/params.h>
#include <traverse/multi_lidar_grid/unit_map.h>
#include <traverse/poses/pose_track.h>

#include <Eigen/Core>

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
  Sensor(std::string_view of, int32_t region_edge) : label(of), latest(region_edge) {}

  std::string label;
  UnitMap latest;            //!< its latest cloud
  bool has_cloud = false;    //!< latest is of a cloud
  poses::TimeNs newest = 0;  //!< stamp of its newest cloud, in the poses' time
  double period_s = 0;       //!< usual time between clouds; 0: not known
  uint64_t clouds = 0;       //!< taken
  uint64_t refused = 0;      //!< clouds later than order_window_s, or of a stuck sensor on the move

  uint64_t last_hash = 0;                                //!< of the newest cloud's points
  uint32_t repeats = 0;                                  //!< clouds in a row with that hash
  Eigen::Vector3d repeats_at = Eigen::Vector3d::Zero();  //!< where the first of them was taken, m

  ClockOffset clock;
  double clock_offset_s = 0;  //!< in use: added to its stamps
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

  const std::deque<Sensor>& all() const { return sensors_; }

  std::deque<Sensor>& all() { return sensors_; }

 private:
  std::deque<Sensor> sensors_;
};

Health healthOf(const Sensor& sensor, poses::TimeNs now, const Params& params);

/** False of sensors whose latest cloud says nothing of now. */
inline bool counts(Health health)
{
  return health == Health::ok || health == Health::late;
}

/** Why a cloud is refused. */
enum class Refusal : uint8_t
{
  none,
  too_late,  //!< order_window_s
  stuck,     //!< the same cloud as before, from another place
};

/** Notes that a cloud arrived and from where; whether to take it. `stamp` in the poses' time. */
Refusal arrive(
    Sensor& sensor,
    const points::Scan& scan,
    poses::TimeNs stamp,
    const Eigen::Vector3d& place,
    const Params& params);
}  // namespace traverse::multi_lidar_grid
