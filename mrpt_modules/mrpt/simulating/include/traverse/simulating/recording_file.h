// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/config/ini_document.h>
#include <traverse/simulation/recording.h>

#include <string>
#include <string_view>

namespace traverse::simulating
{
/** True for a section that says what is recorded: Vehicle, Drive, Lidar_00 ..., Ins, Odometry. */
bool isOfRecording(std::string_view section);

/** What an ini says of the recording; sections that are not its own are left to others. Without a
 * [Lidar_00] there is one HDL-32E. Throws config::ConfigError, with file and line, for unknown
 * keys, values out of range, gaps in the lidars' numbers, and two sensors of one name. */
simulation::RecordingParams readRecording(const config::IniDocument& ini);

/** The same as an ini, every key written out; readRecording() gives the same parameters. */
std::string recordingText(const simulation::RecordingParams& params);
}  // namespace traverse::simulating
