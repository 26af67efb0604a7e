// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "entries.h"

#include <array>
#include <string>

namespace traverse::importing
{
/** One line of KITTI's inertial and GPS unit, in the order of its dataformat.txt: lat lon alt, roll
 * pitch yaw, vn ve vf vl vu, ax ay az af al au, wx wy wz wf wl wu, two accuracies, five states. */
using Oxts = std::array<double, 30>;

/** Throws ImportError for another number of values, or a place that is none on earth. */
Oxts readOxts(const std::string& text);

/** CObservationGPS with a GGA message: latitude, longitude, altitude (as KITTI has it). */
Entry gpsEntry(const Oxts& oxts, const SensorAt& sensor);

/** CObservationIMU: orientation, rates, accelerations, velocities. */
Entry imuEntry(const Oxts& oxts, const SensorAt& sensor);
}  // namespace traverse::importing
