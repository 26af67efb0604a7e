// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/nav_app/closed_loop.h>

namespace traverse::app
{
/** What came of a replay. */
struct ReplayResult : DriveResult
{
  double off_track_s = 0;  //!< time without a pose
  uint64_t scans = 0;      //!< that the maps took
  uint64_t scans_without_pose = 0;
  std::string problem;  //!< what is wrong with the log; empty where nothing is
};

/** What the pilot would have commanded, had it sat in the vehicle that recorded a log: scans, poses
 * ([Poses]) and motion are the log's, and no command has an effect. Its goals are those of the ini,
 * each until the vehicle was nearest to it, else places of the recorded way, each until half of
 * [traverse-nav] goal_every_m before it. Where
 * it gives up it starts over at the next goal.
 *
 * A scan comes in at the time of its latest point. Clearances and collisions are those of the
 * recorded way and what the maps call an obstacle, at the time: a vehicle that drove unharmed where
 * they say so has found a false one. Throws logs::LogError, config::ConfigError. */
ReplayResult replay(
    const NavSettings& settings,
    const std::filesystem::path& log,
    Pilot& pilot,
    const DriveOptions& options);
}  // namespace traverse::app
