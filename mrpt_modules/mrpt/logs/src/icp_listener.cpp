// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "odometry_track.h"
#include "reader_job.h"

#include <traverse/observations/convert.h>

#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/slam/CMetricMapBuilderICP.h>

#include <cmath>

namespace traverse::logs
{
namespace
{
using mrpt::obs::CObservation2DRangeScan;
constexpr double kLevelRad = 0.175;

/** To 1 um and 0.1 urad, far below what ICP can tell: the last bits of MRPT's arithmetic are those
 * of libm, which differ between processors. */
mrpt::poses::CPose2D rounded(const mrpt::poses::CPose3D& pose)
{
  constexpr double kPerMetre = 1e6;
  constexpr double kPerRadian = 1e7;
  return {
      std::nearbyint(pose.x() * kPerMetre) / kPerMetre,
      std::nearbyint(pose.y() * kPerMetre) / kPerMetre,
      std::nearbyint(pose.yaw() * kPerRadian) / kPerRadian};
}

/** Values that MRPT would abort on, or take for a wall: out. */
void clean(CObservation2DRangeScan& scan)
{
  for (size_t i = 0; i < scan.getScanSize(); ++i)
  {
    if (!std::isfinite(scan.getScanRange(i)) || scan.getScanRange(i) <= 0)
    {
      scan.setScanRange(i, 0);
      scan.setScanRangeValidity(i, false);
    }
  }
}

bool usable(const CObservation2DRangeScan& scan)
{
  const auto finite = observations::toIsometry(scan.sensorPose).matrix().allFinite();
  return scan.getScanSize() > 1 && finite && std::isfinite(scan.aperture) && scan.aperture > 0 &&
         std::isfinite(scan.maxRange) && scan.isPlanarScan(kLevelRad);
}

/** Matching against a cloud of the walls so far, a new scan of them every metre or half turn. */
void configure(mrpt::slam::CMetricMapBuilderICP& builder)
{
  builder.setVerbosityLevel(mrpt::system::LVL_ERROR);
  mrpt::maps::CSimplePointsMap::TMapDefinition walls;
  walls.insertionOpts.minDistBetweenLaserPoints = 0.05F;
  walls.insertionOpts.also_interpolate = false;
  builder.ICP_options.mapInitializers.push_back(walls);
  builder.ICP_options.matchAgainstTheGrid = false;
  builder.ICP_options.insertionLinDistance = 0.75;
  builder.ICP_options.insertionAngDistance = 0.5;
  builder.ICP_options.localizationLinDistance = 0.2;
  builder.ICP_options.localizationAngDistance = 0.1;
  builder.ICP_options.minICPgoodnessToAccept = 0.4;
  builder.ICP_params.maxIterations = 80;
  builder.ICP_params.thresholdDist = 0.5;
  builder.ICP_params.smallestThresholdDist = 0.05;
  builder.ICP_params.ALFA = 0.8;
  builder.initialize();
}

class IcpListener : public FrameListener
{
 public:
  IcpListener(FramePipe& pipe, const JobSettings& settings) :
      FrameListener(pipe), labels_(settings.sensors.sensor_labels)
  {
    configure(builder_);
  }

  void observation(const mrpt::obs::CObservation::Ptr& observation) override
  {
    const std::string type = typeOf(*observation);
    const bool odometry = track_.add(*observation);
    const auto scan = std::dynamic_pointer_cast<CObservation2DRangeScan>(observation);
    if (odometry)
    {
      giveOdometry(track_.take());
    }
    else if (!scan || (!labels_.empty() && !observations::hasLabel(labels_, scan->sensorLabel)))
    {
      count(Counted::ignored, type);
    }
    else
    {
      match(type, scan);
    }
  }

  void movement(const Movement& movement) override { track_.add(movement); }

  void frameEnd() override
  {
    track_.frameEnd();
    track_.take();
    moved_ = false;
  }

 private:
  void match(const std::string& type, const CObservation2DRangeScan::Ptr& scan)
  {
    const auto stamp = observations::toTime(scan->timestamp);
    countStamp(type, scan->sensorLabel, stamp.value_or(0));
    if (!stamp || !usable(*scan))
    {
      count(
          Counted::rejected, type,
          stamp ? "it is no level scan of several beams" : "its time stamp is no clock's");
      return;
    }
    clean(*scan);
    if (!moved_)
    {
      // The movement that led to this frame; MRPT wants it as odometry with a stamp.
      giveOdometry(poses::StampedPose{*stamp, track_.pose()});
      moved_ = true;
    }
    builder_.processObservation(scan);
    const auto pose = builder_.getCurrentPoseEstimation()->getMeanVal();
    frames().add(poses::StampedPose{*stamp, observations::toIsometry(rounded(pose))});
    count(Counted::delivered, type);
  }

  void giveOdometry(const std::optional<poses::StampedPose>& pose)
  {
    if (!pose || pose->time == 0 || !track_.any())
    {
      return;
    }
    const auto odometry = mrpt::obs::CObservationOdometry::Create();
    odometry->timestamp = observations::toTimePoint(pose->time);
    odometry->odometry = mrpt::poses::CPose2D(observations::toPose3D(pose->T_map_base));
    builder_.processObservation(odometry);
  }

  std::string labels_;
  mrpt::slam::CMetricMapBuilderICP builder_;
  OdometryTrack track_;
  bool moved_ = false;  // the odometry of this frame was given
};
}  // namespace

std::unique_ptr<FrameListener> makeIcpListener(FramePipe& pipe, const JobSettings& settings)
{
  return std::make_unique<IcpListener>(pipe, settings);
}
}  // namespace traverse::logs
