// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/small_reactive_driver.h"

#include <mrpt/core/Clock.h>

#include <gtest/gtest.h>

namespace traverse::testing
{
namespace
{
// What MRPT 2.5.8 does wrong, each seen to fail without what sets it right.

TEST_F(ReactiveDriver, StopsForObstaclesOfAnyHeight)
{
  for (const Navigator navigator : {Navigator::flat, Navigator::levels})
  {
    params.navigator = navigator;
    make();
    for (const float z_m : {-1.0F, 0.0F, 0.5F, 1.0F, 30.0F})
    {
      SCOPED_TRACE(z_m);
      senses.obstacles.clear();
      closeIn(z_m);
      driver->follow({{2, 0}});
      EXPECT_EQ(stepAfter(0.1).outcome, Outcome::no_motion);
    }
  }
}

TEST_F(ReactiveDriver, StandsUntilAPlaceCanBeReachedWhereTheFirstOneCannot)
{
  drivetrain.steering = Steering::ackermann;
  drivetrain.max_reverse_mps = 0;
  make();
  driver->follow({{0.1, 0.9}});  // inside its turning circle; MRPT: ERR201 for ever after
  EXPECT_NE(stepAfter(0.1).outcome, Outcome::failed);
  driver->follow({{2, 0.3}});
  EXPECT_EQ(stepAfter(0.1).outcome, Outcome::driving);
}

TEST_F(ReactiveDriver, SeesANewPoseAfterAMillisecond)
{
  make();
  driver->follow({{2, 2}});
  EXPECT_GT(stepAfter(0.1).twist.yaw_rate_radps, 0.1);
  senses.pose.yaw_rad = M_PI / 2;  // MRPT: looks at no new pose within 20 ms
  EXPECT_LT(stepAfter(0.001).twist.yaw_rate_radps, -0.1);
}

TEST_F(ReactiveDriver, SaysThatItFailedWhenItComesNoNearerFor30Seconds)
{
  make();
  driver->follow({{2, 0}});
  closeIn(0.3F);
  double seconds = 0;
  Command command;
  for (; seconds < 40 && command.outcome != Outcome::failed; seconds += 0.5)
  {
    command = stepAfter(0.5);
  }
  EXPECT_NEAR(seconds, 30, 1.1) << "one or two steps more than MRPT's time";
  EXPECT_EQ(command.text, "it has come no nearer to the place that it drives to for 30 s");
  senses.obstacles.clear();
  EXPECT_EQ(stepAfter(0.5).outcome, Outcome::driving) << "it tries again";
}

TEST_F(ReactiveDriver, HasNotArrivedWhereItsPoseJumpedOverTheGoal)
{
  make();
  driver->follow({{2, 0}});
  EXPECT_EQ(stepAfter(0.1).outcome, Outcome::driving);
  senses.pose.x_m = 4;  // MRPT: the goal lies on the line between the two
  EXPECT_EQ(stepAfter(0.1).outcome, Outcome::driving);
  senses.pose.x_m = 1.9;
  EXPECT_EQ(stepAfter(0.1).outcome, Outcome::arrived);
}

TEST_F(ReactiveDriver, DrivesOnAsBeforeWhenItsPoseJumpsAwayAndBack)
{
  make();
  driver->follow({{2, 1}, {2, -1}, {3, 0}});
  EXPECT_GT(stepAfter(0.1).twist.yaw_rate_radps, 0.1);
  senses.pose = {6, 3, 0};  // MRPT: it has been at the first place in between
  stepAfter(0.1);
  senses.pose = {};
  EXPECT_GT(stepAfter(0.1).twist.yaw_rate_radps, 0.1);
}

TEST_F(ReactiveDriver, DrivesOnWhenTimesGoBack)
{
  make();
  driver->follow({{2, 0}});
  EXPECT_EQ(stepAfter(100).outcome, Outcome::driving);
  EXPECT_EQ(stepAfter(-50).outcome, Outcome::driving);
  EXPECT_EQ(stepAfter(0).outcome, Outcome::driving);
}

TEST_F(ReactiveDriver, KeepsTheGridsOfEachVehicleInAFolderOfItsOwn)
{
  make();
  ASSERT_EQ(namesIn(scratch / "grids").size(), 1U);
  const std::string first = namesIn(scratch / "grids").front();
  EXPECT_EQ(namesIn(scratch / "grids" / first).size(), 3U + 1) << "and their check sums";
  make();
  EXPECT_EQ(namesIn(scratch / "grids").size(), 1U);
  drivetrain.max_yaw_rate_degps = 50;
  make();
  EXPECT_EQ(namesIn(scratch / "grids").size(), 2U);
}

TEST_F(ReactiveDriver, DrivesTheSameWithFreshStoredAndDamagedGrids)
{
  make();
  senses.obstacles = {{1.0F, 0.2F, 0.3F}, {1.2F, 0.2F, 0.3F}};
  driver->follow({{2, 0.4}});
  const geometry::Twist2 fresh = stepAfter(0.1).twist;
  const std::filesystem::path folder = scratch / "grids" / namesIn(scratch / "grids").front();
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  for (const size_t bytes : {size_t{1'000'000}, size_t{2000}, size_t{0}})
  {
    for (const std::string& name : namesIn(folder))
    {
      writeText(folder / name, readText(folder / name).substr(0, bytes));
    }
    make();
    driver->follow({{2, 0.4}});
    const geometry::Twist2 again = stepAfter(0.1).twist;
    EXPECT_EQ(again.speed_mps, fresh.speed_mps) << bytes;
    EXPECT_EQ(again.yaw_rate_radps, fresh.yaw_rate_radps) << bytes;
  }
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST_F(ReactiveDriver, PrintsNothing)
{
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  make(scratch / "logs");
  driver->follow({{2, 0}});
  stepAfter(0.1);
  closeIn(0.3F);
  stepAfter(31);
  stepAfter(31);
  driver.reset();
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST_F(ReactiveDriver, LeavesMrptsClockAsItWas)
{
  make();
  EXPECT_EQ(mrpt::Clock::getActiveClock(), mrpt::Clock::Realtime);
  driver->follow({{2, 0}});
  stepAfter(0.1);
  EXPECT_EQ(mrpt::Clock::getActiveClock(), mrpt::Clock::Realtime);
  const auto others = mrpt::Clock::fromDouble(12345);
  mrpt::Clock::setSimulatedTime(others);
  mrpt::Clock::setActiveClock(mrpt::Clock::Simulated);
  stepAfter(0.1);
  EXPECT_EQ(mrpt::Clock::getActiveClock(), mrpt::Clock::Simulated);
  EXPECT_EQ(mrpt::Clock::now(), others);
  mrpt::Clock::setActiveClock(mrpt::Clock::Realtime);
}
}  // namespace
}  // namespace traverse::testing
