// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/reactive/reactive_driver.h>

#include <mrpt/nav/reactive/CRobot2NavInterface.h>

#include <optional>
#include <string>

namespace traverse::reactive
{
/** What MRPT's navigator told its vehicle in one step. */
struct StepEvents
{
  std::optional<geometry::Twist2> twist;  //!< the command, if there was one
  bool way_blocked = false;               //!< it has come no nearer for long
  bool target_blocked = false;            //!< an obstacle stands on the target
  std::string error;                      //!< of its emergency stop
};

/** The vehicle as MRPT's navigator sees it: it senses what it was shown, and notes down what it is
 * told. Times of poses and obstacles are that of what it was shown. */
class SensesInterface : public mrpt::nav::CRobot2NavInterface
{
 public:
  /** height_m: of the vehicle; obstacles are drawn into the heights that MRPT's navigators look at,
   * as all that is shown is an obstacle. */
  explicit SensesInterface(double height_m);

  /** Shows the surroundings of the next step, which must live as long as it, and forgets the last
   * one's events. Points that are not finite are left out. */
  void show(const Senses& senses);

  StepEvents& events() { return events_; }

  bool getCurrentPoseAndSpeeds(
      mrpt::math::TPose2D& pose,
      mrpt::math::TTwist2D& velocity,
      mrpt::system::TTimeStamp& time,
      mrpt::math::TPose2D& odometry,
      std::string& frame) override;
  bool senseObstacles(
      mrpt::maps::CSimplePointsMap& obstacles, mrpt::system::TTimeStamp& time) override;
  bool changeSpeeds(const mrpt::kinematics::CVehicleVelCmd& command) override;
  bool changeSpeedsNOP() override;
  bool stop(bool is_emergency) override;
  mrpt::kinematics::CVehicleVelCmd::Ptr getEmergencyStopCmd() override;
  mrpt::kinematics::CVehicleVelCmd::Ptr getStopCmd() override;

  bool startWatchdog(float) override { return true; }

  bool stopWatchdog() override { return true; }

  double getNavigationTime() override { return navigation_time_s_; }

  void resetNavigationTimer() override {}

  void sendNavigationStartEvent() override {}

  void sendNavigationEndEvent() override {}

  void sendWaypointReachedEvent(int, bool) override {}

  void sendNewWaypointTargetEvent(int) override {}

  void sendNavigationEndDueToErrorEvent() override {}

  void sendWaySeemsBlockedEvent() override { events_.way_blocked = true; }

  void sendApparentCollisionEvent() override {}

  void sendCannotGetCloserToBlockedTargetEvent() override { events_.target_blocked = true; }

 private:
  double height_m_;
  const Senses* shown_ = nullptr;
  StepEvents events_;
  geometry::Twist2 last_twist_;
  double navigation_time_s_ = 0;
};
}  // namespace traverse::reactive
