// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "decoders.h"

#include <traverse/observations/cause.h>
#include <traverse/observations/convert.h>
#include <traverse/observations/to_scan.h>
#include <traverse/points/exclude.h>

#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationRotatingScan.h>
#include <mrpt/obs/CObservationVelodyneScan.h>

#include <array>

namespace traverse::observations
{
namespace
{
struct Entry
{
  const mrpt::rtti::TRuntimeClassId* type;
  points::Decoded (*decode)(const Request&);
};

const std::array<Entry, 5>& decoders()
{
  using namespace mrpt::obs;  // NOLINT(google-build-using-namespace): CLASS_ID pastes bare names
  static const std::array<Entry, 5> all = {
      {{CLASS_ID(CObservation2DRangeScan), decode2DRangeScan},
       {CLASS_ID(CObservationVelodyneScan), decodeVelodyneScan},
       {CLASS_ID(CObservation3DRangeScan), decode3DRangeScan},
       {CLASS_ID(CObservationPointCloud), decodePointCloud},
       {CLASS_ID(CObservationRotatingScan), decodeRotatingScan}}};
  return all;
}

void excludeOwnBody(points::Decoded& decoded, const ObservationParams& params)
{
  if (params.own_body_min_m.size() != 3 || params.own_body_max_m.size() != 3)
  {
    return;
  }
  const Eigen::Vector3d low(params.own_body_min_m.data());
  const Eigen::Vector3d high(params.own_body_max_m.data());
  points::excludeBox(decoded, Eigen::AlignedBox3f(low.cast<float>(), high.cast<float>()));
}

ScanResult decodeWith(const Entry& entry, const Request& request)
{
  try
  {
    ScanResult result{Outcome::scan, entry.decode(request), {}};
    excludeOwnBody(result.decoded, request.params);
    return result;
  }
  catch (const std::bad_alloc&)
  {
    throw;  // the reader's memory is used up: not a fault of this observation alone
  }
  catch (const std::exception& e)
  {
    return {Outcome::rejected, {}, causeOf(e)};
  }
}
}  // namespace

poses::TimeNs stampOf(const mrpt::obs::CObservation& observation)
{
  return toTime(observation.timestamp).value_or(0);
}

Eigen::Isometry3d sensorPoseOf(const mrpt::obs::CObservation& observation)
{
  mrpt::poses::CPose3D pose;
  observation.getSensorPose(pose);
  Eigen::Isometry3d T = toIsometry(pose);
  constexpr double kFurthestMetres = 1e4;
  if (!T.matrix().allFinite() || T.translation().norm() > kFurthestMetres)
  {
    throw Refused("its sensor pose is no pose on a vehicle");
  }
  return T;
}

ScanResult toScan(
    const mrpt::obs::CObservation& observation,
    const ObservationParams& params,
    const std::filesystem::path& image_folder)
{
  const mrpt::rtti::TRuntimeClassId* type = observation.GetRuntimeClass();
  for (const Entry& entry : decoders())
  {
    if (!type->derivedFrom(entry.type))
    {
      continue;
    }
    if (!params.sensor_labels.empty() && !hasLabel(params.sensor_labels, observation.sensorLabel))
    {
      return {Outcome::ignored, {}, "its label is not in sensor_labels"};
    }
    return decodeWith(entry, {observation, params, image_folder});
  }
  return {Outcome::ignored, {}, "it is no range measurement"};
}
}  // namespace traverse::observations
