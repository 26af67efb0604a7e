// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/maps/CTraversabilityGridMap.h>

#include <mrpt/maps/registerAllClasses.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservation.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3D.h>

#include <stdexcept>
#include <string>
#include <support/data.h>
#include <vector>

namespace traverse::testing
{
/** An observation of a stock log and where odometry says it was taken. */
struct LoggedObservation
{
  mrpt::obs::CObservation::Ptr observation;
  mrpt::poses::CPose3D pose;
};

/** All observations of one of Debian's logs (known to be sound: MRPT's reader crashes on others).
 */
inline std::vector<LoggedObservation> readStockLog(const std::string& file)
{
  mrpt::maps::registerAllClasses_mrpt_maps();
  mrpt::obs::CRawlog log;
  if (!log.loadFromRawLogFile(file))
  {
    throw std::runtime_error("cannot read " + file);
  }
  std::vector<LoggedObservation> all;
  mrpt::poses::CPose2D pose;
  for (size_t i = 0; i < log.size(); ++i)
  {
    switch (log.getType(i))
    {
      case mrpt::obs::CRawlog::etObservation:
        all.push_back({log.getAsObservation(i), mrpt::poses::CPose3D(pose)});
        break;
      case mrpt::obs::CRawlog::etSensoryFrame:
        for (const auto& observation : *log.getAsObservations(i))
        {
          all.push_back({observation, mrpt::poses::CPose3D(pose)});
        }
        break;
      case mrpt::obs::CRawlog::etActionCollection:
        if (const auto move = log.getAsAction(i)->getBestMovementEstimation())
        {
          pose = pose + move->poseChange->getMeanVal();
        }
        break;
      default:
        break;
    }
  }
  return all;
}

inline const std::string kVelodyneLog = mrptData("test_velodyne_VLP16.rawlog");
inline const std::string kLaserLog =
    mrptData("2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog");

/** The first range observation of a stock log. */
inline mrpt::obs::CObservation::Ptr firstOf(const std::string& log)
{
  for (const LoggedObservation& logged : readStockLog(log))
  {
    if (maps::CTraversabilityGridMap().canComputeObservationLikelihood(*logged.observation))
    {
      return logged.observation;
    }
  }
  throw std::runtime_error("no range observation in " + log);
}
}  // namespace traverse::testing
