// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/small_reactive_driver.h"

#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/nav/reactive/CLogFileRecord.h>
#include <mrpt/serialization/CArchive.h>

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace traverse::testing
{
namespace
{
TEST_F(ReactiveDriver, StandsWithNothingToFollow)
{
  make();
  EXPECT_EQ(stepAfter(0.1).outcome, Outcome::idle);
  driver->follow({{2, 0}});
  EXPECT_EQ(stepAfter(0.1).outcome, Outcome::driving);
  driver->follow({});
  const Command command = stepAfter(0.1);
  EXPECT_EQ(command.outcome, Outcome::idle);
  EXPECT_EQ(command.twist.speed_mps, 0);
}

TEST_F(ReactiveDriver, HasArrivedUntilItIsToldToFollowAnew)
{
  make();
  driver->follow({{0.1, 0}});
  EXPECT_EQ(stepAfter(0.1).outcome, Outcome::arrived);
  EXPECT_EQ(stepAfter(0.1).outcome, Outcome::arrived);
  driver->follow({{2, 0}});
  EXPECT_EQ(stepAfter(0.1).outcome, Outcome::driving);
}

TEST_F(ReactiveDriver, SaysWithinASecondThatAClosedRoomHasNoWayOut)
{
  for (const Navigator navigator : {Navigator::flat, Navigator::levels})
  {
    for (const Steering steering : {Steering::differential, Steering::ackermann})
    {
      params.navigator = navigator;
      drivetrain.steering = steering;
      senses = {};
      make();
      driver->follow({{5, 0}, {6, 0}});
      EXPECT_EQ(stepAfter(0.1).outcome, Outcome::driving);
      closeIn(0.3F);
      Command command;
      for (int n = 0; n < 10; ++n)
      {
        command = stepAfter(0.1);
      }
      EXPECT_EQ(command.outcome, Outcome::no_motion);
      EXPECT_EQ(command.twist.speed_mps, 0);
      EXPECT_EQ(command.twist.yaw_rate_radps, 0);
      EXPECT_EQ(
          command.text,
          "no trajectory to the next place is free: 84 obstacle points, 0 of them in the outline");
    }
  }
}

TEST_F(ReactiveDriver, SaysThatObstaclesAreInItsOutline)
{
  make();
  driver->follow({{2, 0}});
  closeIn(0.3F);
  senses.obstacles.insert(senses.obstacles.end(), {{0.3F, 0, 0.3F}, {-0.1F, 0.2F, 0.3F}});
  EXPECT_EQ(
      stepAfter(0.1).text,
      "no trajectory to the next place is free: 86 obstacle points, 2 of them in the outline");
}

TEST_F(ReactiveDriver, DoesNotDriveToAnObstacleOnTheGoal)
{
  make();
  const std::vector<Disc> discs = {{{3, 0}, 0.3}};
  const Drive drive = driveAmong(discs, {{1, 0}, {2, 0}, {3, 0}}, *driver, vehicle, 20);
  EXPECT_NE(drive.outcome, Outcome::arrived);
  EXPECT_GT(drive.least_clearance_m, 0);
}

TEST_F(ReactiveDriver, SlowsDownAlongTheSameArc)
{
  make();
  driver->follow({{2, 1}});
  const geometry::Twist2 full = stepAfter(0.1).twist;
  ASSERT_GT(full.speed_mps, 0.3);
  ASSERT_GT(full.yaw_rate_radps, 0.1);
  senses.speed_limit_mps = full.speed_mps / 4;
  const geometry::Twist2 slow = stepAfter(0.1).twist;
  EXPECT_DOUBLE_EQ(slow.speed_mps, senses.speed_limit_mps);
  // The arc chosen in a second step at the same place is the same; 1e-9 is for the quotients.
  EXPECT_NEAR(slow.yaw_rate_radps / slow.speed_mps, full.yaw_rate_radps / full.speed_mps, 1e-9);
  for (const double none : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
  {
    senses.speed_limit_mps = none;
    const geometry::Twist2 standing = stepAfter(0.1).twist;
    EXPECT_EQ(standing.speed_mps, 0);
    EXPECT_EQ(standing.yaw_rate_radps, 0);
  }
}

TEST_F(ReactiveDriver, RefusesWhatIsNoPlaceAndNoVehicle)
{
  make();
  EXPECT_THROW(driver->follow({{1, 0}, {NAN, 0}}), std::invalid_argument);
  vehicle.footprint_xs_m.pop_back();
  EXPECT_THROW(
      reactive::ReactiveDriver(vehicle, drivetrain, params, scratch / "grids"),
      options::OptionError);
  vehicle.footprint_ys_m.pop_back();
  params.reference_distance_m = 100;
  params.grid_resolution_m = 0.01;
  EXPECT_THROW(
      reactive::ReactiveDriver(vehicle, drivetrain, params, scratch / "grids"),
      options::OptionError);
}

TEST_F(ReactiveDriver, WritesALogThatMrptReads)
{
  make(scratch / "logs");
  driver->follow({{2, 0}});
  for (int n = 0; n < 5; ++n)
  {
    stepAfter(0.1);
  }
  driver.reset();
  ASSERT_EQ(namesIn(scratch / "logs").size(), 1U);
  const std::string name = namesIn(scratch / "logs").front();
  EXPECT_EQ(std::filesystem::path(name).extension(), ".reactivenavlog");
  mrpt::io::CFileGZInputStream file((scratch / "logs" / name).string());
  auto archive = mrpt::serialization::archiveFrom(file);
  for (int n = 0; n < 5; ++n)
  {
    mrpt::nav::CLogFileRecord record;
    archive >> record;
    EXPECT_EQ(record.infoPerPTG.size(), 4U) << "3 families, and going on as before";
  }
  mrpt::nav::CLogFileRecord none;
  EXPECT_THROW(archive >> none, std::exception);
}

TEST_F(ReactiveDriver, FailsForPosesThatAreNone)
{
  make();
  driver->follow({{2, 0}});
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e300})
  {
    senses.pose.x_m = bad;
    const Command command = stepAfter(0.1);
    EXPECT_EQ(command.outcome, Outcome::failed);
    EXPECT_EQ(command.text, "the pose or motion is none that a vehicle can have");
  }
  senses.pose.x_m = 0;
  EXPECT_EQ(stepAfter(0.1).outcome, Outcome::driving);
}

TEST_F(ReactiveDriver, LeavesOutObstaclesThatAreNoPoints)
{
  make();
  driver->follow({{2, 0}});
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float far = std::numeric_limits<float>::max();
  senses.obstacles = {{nan, 0, 0}, {0.6F, 0, nan}, {far, -far, far}};
  EXPECT_EQ(stepAfter(0.1).outcome, Outcome::driving);
}
}  // namespace
}  // namespace traverse::testing
