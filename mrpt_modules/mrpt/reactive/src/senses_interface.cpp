// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "senses_interface.h"

#include "simulated_clock.h"

#include <mrpt/kinematics/CVehicleVelCmd_DiffDriven.h>
#include <mrpt/maps/CSimplePointsMap.h>

#include <algorithm>
#include <cmath>

namespace traverse::reactive
{
namespace
{
// MRPT's navigator asks for no new pose within 20 ms of its vehicle's own clock. Ours goes on by
// more from step to step.
constexpr double kClockStep_s = 0.1;

// ...3D leaves out what is lower than 1 cm, and what is as high as its prisms together or higher;
// the flat one what is below the ground.
constexpr float kLowest_m = 0.02F;
constexpr float kHighestOfHeight = 0.98F;

mrpt::kinematics::CVehicleVelCmd::Ptr standing()
{
  auto command = mrpt::kinematics::CVehicleVelCmd_DiffDriven::Create();
  command->setToStop();
  return command;
}
}  // namespace

SensesInterface::SensesInterface(double height_m) : height_m_(height_m)
{
  logging_enable_console_output = false;
}

void SensesInterface::show(const Senses& senses)
{
  shown_ = &senses;
  events_ = {};
  navigation_time_s_ += kClockStep_s;
}

bool SensesInterface::getCurrentPoseAndSpeeds(
    mrpt::math::TPose2D& pose,
    mrpt::math::TTwist2D& velocity,
    mrpt::system::TTimeStamp& time,
    mrpt::math::TPose2D& odometry,
    std::string& frame)
{
  if (shown_ == nullptr)
  {
    return false;
  }
  pose = {shown_->pose.x_m, shown_->pose.y_m, shown_->pose.yaw_rad};
  velocity = {shown_->motion.speed_mps, 0, shown_->motion.yaw_rate_radps};
  velocity.rotate(pose.phi);
  time = mrptTime(shown_->now);
  odometry = pose;
  frame = "map";
  return true;
}

bool SensesInterface::senseObstacles(
    mrpt::maps::CSimplePointsMap& obstacles, mrpt::system::TTimeStamp& time)
{
  obstacles.clear();
  if (shown_ == nullptr)
  {
    return false;
  }
  obstacles.reserve(shown_->obstacles.size());
  const float highest_m = std::max(kLowest_m, static_cast<float>(height_m_) * kHighestOfHeight);
  for (const Eigen::Vector3f& p : shown_->obstacles)
  {
    if (p.allFinite())
    {
      obstacles.insertPointFast(p.x(), p.y(), std::clamp(p.z(), kLowest_m, highest_m));
    }
  }
  obstacles.mark_as_modified();
  time = mrptTime(shown_->now);
  return true;
}

bool SensesInterface::changeSpeeds(const mrpt::kinematics::CVehicleVelCmd& command)
{
  const auto* known = dynamic_cast<const mrpt::kinematics::CVehicleVelCmd_DiffDriven*>(&command);
  if (known == nullptr || !std::isfinite(known->lin_vel) || !std::isfinite(known->ang_vel))
  {
    return false;
  }
  last_twist_ = {known->lin_vel, known->ang_vel};
  events_.twist = last_twist_;
  return true;
}

bool SensesInterface::changeSpeedsNOP()
{
  events_.twist = last_twist_;
  return true;
}

bool SensesInterface::stop(bool)
{
  last_twist_ = {};
  events_.twist.reset();
  return true;
}

mrpt::kinematics::CVehicleVelCmd::Ptr SensesInterface::getEmergencyStopCmd()
{
  return standing();
}

mrpt::kinematics::CVehicleVelCmd::Ptr SensesInterface::getStopCmd()
{
  return standing();
}
}  // namespace traverse::reactive
