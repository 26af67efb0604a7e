// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evidence.h"

#include <cmath>
#include <limits>

namespace traverse::app
{
namespace
{
constexpr size_t kMostSighted = 4000;  // scans of a sensor, 8 kB each
constexpr uint64_t kFirstScans = 20;   // a ground is looked for in all of them,
constexpr uint64_t kEveryScan = 10;    // then in every tenth
constexpr double kMostPlanes = 2000;

/** A ground needs more than one row of beams. */
bool isOfOneRow(const points::Decoded& decoded)
{
  return decoded.image.rows == 1;
}

void lookForGround(const points::Scan& scan, SensorEvidence& sensor)
{
  using diagnosis::GroundSearch;
  ++sensor.looked_at;
  if (const auto level = diagnosis::findGround(scan, GroundSearch::level))
  {
    sensor.ground.push_back(*level);
  }
  else if (const auto tilted = diagnosis::findGround(scan, GroundSearch::any_around))
  {
    sensor.tilted.push_back(*tilted);
  }
}
}  // namespace

void addTo(Evidence& evidence, points::Decoded decoded)
{
  const bool known_label = evidence.sensors.count(decoded.scan.sensor_label) > 0;
  if (!known_label && evidence.sensors.size() >= kMostScanSensors)
  {
    return;
  }
  SensorEvidence& sensor = evidence.sensors[decoded.scan.sensor_label];
  const ScanSensor& seen = evidence.census[decoded.scan.sensor_label];
  const points::Scan scan = decoded.scan.view();
  const bool due = seen.scans < kFirstScans || seen.scans % kEveryScan == 0;
  const bool room = static_cast<double>(sensor.looked_at) < kMostPlanes;
  if (due && room && !isOfOneRow(decoded) && scan.size() > 0)
  {
    lookForGround(scan, sensor);
  }
  if (sensor.sighted.size() < kMostSighted && scan.size() > 0 && scan.stamp != 0)
  {
    const bool known = !sensor.ground.empty();
    const Eigen::Vector3d up = known ? sensor.ground.back().up : Eigen::Vector3d::UnitZ();
    const double offset_m =
        known ? sensor.ground.back().offset_m : -std::numeric_limits<double>::infinity();
    sensor.sighted.push_back(diagnosis::sightedBy(scan, up, offset_m));
  }
  addTo(evidence.census, std::move(decoded));
}

std::optional<diagnosis::GroundSeen> groundOf(const SensorEvidence& sensor)
{
  return sensor.ground.size() * 2 < sensor.looked_at ? std::nullopt
                                                     : diagnosis::agree(sensor.ground);
}
}  // namespace traverse::app
