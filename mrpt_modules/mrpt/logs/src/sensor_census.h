// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wire.h"

#include <traverse/logs/sensor_times.h>

#include <map>
#include <utility>

namespace traverse::logs
{
/** Puts sightings together by sensor. What a hostile log makes up does not fill the memory. */
class SensorCensus
{
 public:
  void add(const SightingFrame& sighting, std::vector<SensorTimes>& sensors);

 private:
  struct Place
  {
    size_t index = 0;
    poses::TimeNs last = 0;  // of the sensor's stamps in file order; 0: none yet
  };

  Place& placeOf(const SightingFrame& sighting, std::vector<SensorTimes>& sensors);

  std::map<std::pair<std::string, std::string>, Place> places_;  // by label and class
  size_t stamps_ = 0;
};
}  // namespace traverse::logs
