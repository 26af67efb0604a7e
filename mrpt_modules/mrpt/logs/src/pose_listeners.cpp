// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "odometry_track.h"
#include "reader_job.h"

#include <traverse/observations/convert.h>

#include <mrpt/obs/CObservationRobotPose.h>

namespace traverse::logs
{
namespace
{
class OdometryListener : public FrameListener
{
 public:
  using FrameListener::FrameListener;

  void observation(const mrpt::obs::CObservation::Ptr& observation) override
  {
    if (!track_.add(*observation))
    {
      count(Counted::ignored, typeOf(*observation));
    }
    send("CObservationOdometry");
  }

  void movement(const Movement& movement) override
  {
    track_.add(movement);
    send("CActionRobotMovement2D");  // the frame before the first movement has its pose now
  }

  void frameEnd() override
  {
    track_.frameEnd();
    send("CActionRobotMovement2D");
  }

 private:
  void send(const std::string& type)
  {
    if (const auto pose = track_.take())
    {
      countStamp(type, "", pose->time);
      if (pose->time == 0)
      {
        count(Counted::rejected, type, "its time stamp is no clock's");
        return;
      }
      frames().add(*pose);
      count(Counted::delivered, type);
    }
  }

  OdometryTrack track_;
};

class RobotPoseListener : public FrameListener
{
 public:
  using FrameListener::FrameListener;

  void observation(const mrpt::obs::CObservation::Ptr& observation) override
  {
    const std::string type = typeOf(*observation);
    const auto pose = std::dynamic_pointer_cast<mrpt::obs::CObservationRobotPose>(observation);
    if (!pose)
    {
      count(Counted::ignored, type);
      return;
    }
    const auto stamp = observations::toTime(pose->timestamp);
    countStamp(type, pose->sensorLabel, stamp.value_or(0));
    if (!stamp)
    {
      count(Counted::rejected, type, "its time stamp is no clock's");
      return;
    }
    const Eigen::Isometry3d T_map_sensor = observations::toIsometry(pose->pose.mean);
    const Eigen::Isometry3d T_base_sensor = observations::toIsometry(pose->sensorPose);
    frames().add(poses::StampedPose{*stamp, T_map_sensor * T_base_sensor.inverse()});
    count(Counted::delivered, type);
  }
};
}  // namespace

std::unique_ptr<FrameListener> makeOdometryListener(FramePipe& pipe)
{
  return std::make_unique<OdometryListener>(pipe);
}

std::unique_ptr<FrameListener> makeRobotPoseListener(FramePipe& pipe)
{
  return std::make_unique<RobotPoseListener>(pipe);
}
}  // namespace traverse::logs
