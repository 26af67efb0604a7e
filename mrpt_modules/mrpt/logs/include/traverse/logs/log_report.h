// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/logs/sensor_times.h>
#include <traverse/sandbox/input_file.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace traverse::logs
{
/** A log that cannot be opened: missing, a directory, no plain file, empty, or not readable; says
 * the file and why. */
using LogError = sandbox::InputError;

/** How reading ended. */
enum class LogEnd : uint8_t
{
  reading,    //!< it has not
  complete,   //!< at the file's end, everything in order
  damaged,    //!< the file is cut short or corrupt; what came before was delivered
  not_a_log,  //!< not even the first object could be read: some other kind of file
  stopped,    //!< on request
};

/** What was met in a log. Class names are MRPT's, without "mrpt::obs::". */
struct LogReport
{
  LogEnd end = LogEnd::reading;
  std::string damage;    //!< file, cause, object number and byte; empty where complete
  uint64_t objects = 0;  //!< entries of the log: observations, actions, sensory frames
  std::map<std::string, uint64_t> observations;  //!< scans (or poses) delivered, by class
  std::map<std::string, uint64_t> ignored;       //!< by class
  std::map<std::string, uint64_t> rejected;      //!< by "class: reason"
  std::map<std::string, std::string> notes;      //!< what a pose source has to say of its poses
  uint64_t repeated_stamps = 0;  //!< the same stamp again from one sensor (delivered all the same)
  uint64_t backward_stamps = 0;  //!< a stamp before its predecessor's (delivered all the same)
  uint64_t bad_stamps = 0;       //!< no clock's: before 1980, after 2100, or none
  std::vector<SensorTimes> sensors;  //!< LogReader only: every observation that was passed
  /** Clouds by what became of their rings and times ("attached", ...), where the log has a file of
   * such beside it (formats/point_channels.h). */
  std::map<std::string, uint64_t> channels;
  std::string channels_damage;  //!< what is wrong with that file; empty where nothing is
  uint64_t bytes_read = 0;      //!< of the file, as it is stored
  uint64_t file_size = 0;

  bool complete() const { return end == LogEnd::complete; }
};
}  // namespace traverse::logs
