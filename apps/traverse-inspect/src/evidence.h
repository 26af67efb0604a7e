// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hint.h"
#include "scan_census.h"

#include <traverse/diagnosis/crispness.h>
#include <traverse/diagnosis/ground_plane.h>
#include <traverse/diagnosis/travel.h>
#include <traverse/logs/log_report.h>
#include <traverse/poses/pose_track.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace traverse::app
{
/** What one sensor's scans show; of a bounded number of them. */
struct SensorEvidence
{
  std::vector<diagnosis::GroundPlane> ground;  //!< below the sensor, about level
  std::vector<diagnosis::GroundPlane> tilted;  //!< all around it, in scans without the former
  std::vector<diagnosis::Sighted> sighted;
  uint64_t looked_at = 0;  //!< scans of several rows in which a ground was looked for
};

/** What the doctor goes by. */
struct Evidence
{
  logs::LogReport report;
  ScanCensus census;
  std::map<std::string, SensorEvidence> sensors;  //!< by label
  std::string pose_source;                        //!< empty: the log has no poses
  poses::PoseTrack track;
  diagnosis::Travel travel;  //!< of that track
};

void addTo(Evidence& evidence, points::Decoded decoded);

/** Median ground of a sensor; nothing where less than half of its scans show one. */
std::optional<diagnosis::GroundSeen> groundOf(const SensorEvidence& sensor);

// What to make of it, room by room.
void hintAtTimes(const Evidence& evidence, Hints& hints);
void hintAtGeometry(const Evidence& evidence, Hints& hints);
void hintAtPoses(const Evidence& evidence, Hints& hints);
}  // namespace traverse::app
