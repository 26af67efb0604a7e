// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/poses/pose_track.h>

#include <cstdint>
#include <string>
#include <vector>

namespace traverse::logs
{
/** When one sensor spoke: all observations of one label and class, whatever became of them. */
struct SensorTimes
{
  std::string label;  //!< as in the log, cut and with '?' for what cannot be printed
  std::string type;   //!< MRPT's class without "mrpt::obs::"
  uint64_t count = 0;
  uint64_t repeated = 0;    //!< the same stamp as its predecessor's
  uint64_t backward = 0;    //!< a stamp before its predecessor's
  uint64_t bad = 0;         //!< no clock's: before 1980, after 2100, or none
  poses::TimeNs first = 0;  //!< the earliest good stamp; 0 where there is none
  poses::TimeNs last = 0;   //!< the latest

  /** Good stamps in file order; the first kMostStamps of all sensors together, then none more. */
  std::vector<poses::TimeNs> stamps;

  /** Of the first observation; not finite where the log has it so, or the class has none. */
  Eigen::Isometry3d T_base_sensor = Eigen::Isometry3d::Identity();
  bool sensor_pose_changes = false;  //!< a later observation has another one

  static constexpr size_t kMostStamps = size_t{16} << 20U;
};
}  // namespace traverse::logs
