// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/simulation/recording.h>

#include <mrpt/obs/CObservation.h>

namespace traverse::simulating
{
/** What a driver would have logged: CObservationVelodyneScan (with the manufacturer's calibration),
 * CObservationRobotPose, CObservationOdometry. timestamp is the sensor's own stamp, to 100 ns; a
 * turn's originalReceivedTimestamp is its arrival. */
mrpt::obs::CObservation::Ptr toObservation(
    const simulation::Event& event, const simulation::RecordingParams& params);
}  // namespace traverse::simulating
