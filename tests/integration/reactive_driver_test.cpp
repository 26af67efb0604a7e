// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/disc_course.h"
#include "support/scratch_folder.h"

#include <mrpt/core/Clock.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/nav/reactive/CLogFileRecord.h>
#include <mrpt/serialization/CArchive.h>

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace traverse::testing
{
namespace
{
using geometry::Steering;
using reactive::Command;
using reactive::Navigator;
using reactive::Outcome;
using reactive::Senses;

constexpr poses::TimeNs start_ns = 1'700'000'000'000'000'000;

std::vector<std::string> namesIn(const std::filesystem::path& folder)
{
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    names.push_back(entry.path().filename());
  }
  return names;
}

/** One small driver and what it is shown, step by step, standing at the origin. */
class ReactiveDriver : public ::testing::Test
{
 protected:
  void make(const std::filesystem::path& log_folder = {})
  {
    vehicle.footprint_xs_m = {-0.2, 0.5, 0.5, -0.2};
    vehicle.footprint_ys_m = {-0.25, -0.25, 0.25, 0.25};
    vehicle.height_m = 1;
    params.reference_distance_m = 3;
    params.paths = 41;
    params.grid_resolution_m = 0.1;
    senses.now = start_ns;
    senses.speed_limit_mps = 10;
    driver = std::make_unique<reactive::ReactiveDriver>(
        vehicle, drivetrain, params, scratch / "grids", log_folder);
  }

  Command stepAfter(double dt_s)
  {
    senses.now = poses::later(senses.now, dt_s);
    return driver->step(senses);
  }

  /** A wall around the vehicle, a hand's breadth away, points z_m high. */
  void closeIn(float z_m)
  {
    for (int k = 0; k <= 20; ++k)
    {
      const float x = -0.3F + 0.045F * static_cast<float>(k);
      const float y = -0.35F + 0.035F * static_cast<float>(k);
      senses.obstacles.insert(
          senses.obstacles.end(),
          {{x, -0.35F, z_m}, {x, 0.35F, z_m}, {-0.3F, y, z_m}, {0.6F, y, z_m}});
    }
  }

  ScratchFolder scratch;
  geometry::Vehicle vehicle;
  geometry::Drivetrain drivetrain;
  reactive::ReactiveParams params;
  Senses senses;
  std::unique_ptr<reactive::ReactiveDriver> driver;
};

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
  int records = 0;
  EXPECT_THROW(
      while (true) {
        mrpt::nav::CLogFileRecord record;
        archive >> record;
        EXPECT_EQ(record.infoPerPTG.size(), 4U) << "3 families, and going on as before";
        ++records;
      },
      std::exception);
  EXPECT_EQ(records, 5);
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
