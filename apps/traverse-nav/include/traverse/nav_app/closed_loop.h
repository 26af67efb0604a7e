// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/nav_app/pilot.h>
#include <traverse/nav_app/settings.h>
#include <traverse/simulation/lidar.h>
#include <traverse/simulation/scene.h>
#include <traverse/simulation/vehicle_model.h>

#include <atomic>
#include <functional>
#include <string>
#include <vector>

namespace traverse::app
{
/** A scene and what is to be done in it. */
struct Mission
{
  simulation::Scene scene;
  geometry::Pose2 start;
  std::vector<navigation::Goal> goals;
};

/** Reads the scene file and makes the scene of a seed; goals of the ini come before the scene's.
 * Throws config::ConfigError. */
Mission readMission(const NavSettings& settings, uint64_t seed);

/** One control step as it was driven. */
struct DriveRecord
{
  double t_s = 0;
  simulation::VehicleState vehicle;
  geometry::Pose2 believed;
  PilotStep pilot;
  double clearance_m = 0;  //!< from the vehicle's outline to what it must not touch; up to 5 m
};

/** What came of a drive. */
struct DriveResult
{
  bool reached = false;
  bool interrupted = false;
  size_t goals_reached = 0;
  uint64_t collisions = 0;       //!< while it moved
  uint64_t struck_standing = 0;  //!< something ran into it
  double min_clearance_m = 5;
  double time_s = 0;  //!< until it arrived or gave up
  double way_m = 0;
  uint64_t stops = 0;                                 //!< on the way
  uint64_t slips = 0;                                 //!< times that the wheels lost their grip
  poses::TimeNs start = simulation::kRecordingStart;  //!< t = 0
  std::string end;                                    //!< why it ended, for people
  std::vector<DriveRecord> records;
};

/** Who watches a drive, and may end it. */
struct DriveOptions
{
  const std::atomic<bool>* stop = nullptr;
  std::function<void(const Pilot&, const DriveResult&)> watch;  //!< after each control step
};

/** Sensors -> maps -> costmap -> way -> reactive layer -> vehicle, until the last goal is reached,
 * the pilot (a new one) gives up, or [traverse-nav] max_time_s is over. The same seed gives the
 * same drive. */
DriveResult drive(
    const NavSettings& settings,
    const Mission& mission,
    uint64_t seed,
    Pilot& pilot,
    const DriveOptions& options);

/** Length of the shortest way through the truth of the scene's standing things from the start by
 * way of all goals, m; NaN where there is none. */
double optimum_m(const NavSettings& settings, const Mission& mission);
}  // namespace traverse::app
