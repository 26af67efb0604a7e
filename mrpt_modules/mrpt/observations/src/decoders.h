// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/observations/observation_params.h>
#include <traverse/points/decoded.h>

#include <filesystem>
#include <stdexcept>

namespace mrpt::obs
{
class CObservation;
}  // namespace mrpt::obs

namespace traverse::observations
{
/** Why an observation is no scan; what() is short, and the same for the same cause. */
class Refused : public std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/** What every decoder gets. */
struct Request
{
  const mrpt::obs::CObservation& observation;  //!< of the class that the decoder is registered for
  const ObservationParams& params;
  std::filesystem::path image_folder;

  points::RangeLimits limits() const
  {
    return {static_cast<float>(params.min_range_m), static_cast<float>(params.max_range_m)};
  }
};

// One for each class, in a file of its own. They throw Refused, or whatever MRPT throws.
points::Decoded decode2DRangeScan(const Request& request);
points::Decoded decode3DRangeScan(const Request& request);
points::Decoded decodePointCloud(const Request& request);
points::Decoded decodeRotatingScan(const Request& request);
points::Decoded decodeVelodyneScan(const Request& request);

/** Stamp of the observation, or 0 where it is no clock's. */
poses::TimeNs stampOf(const mrpt::obs::CObservation& observation);

/** Pose of the sensor on the vehicle; throws Refused where it is not finite. */
Eigen::Isometry3d sensorPoseOf(const mrpt::obs::CObservation& observation);
}  // namespace traverse::observations
