// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <support/supervised_drive.h>

namespace
{
using namespace traverse;
using namespace traverse::navigation;
using namespace traverse::testing;

TEST(Supervisor, DrivesWhileAllIsWell)
{
  SupervisedDrive drive;
  EXPECT_EQ(drive.run(60), Conduct::drive);
  EXPECT_EQ(drive.told(), "drive");
}

TEST(Supervisor, StopsForStaleMapsAndDrivesOnWithNewOnes)
{
  SupervisedDrive drive;
  drive.run(1);
  EXPECT_EQ(
      drive.run(0.5, [](Situation& now) { now.last_scan = poses::later(kStart, 1); }),
      Conduct::drive);
  EXPECT_EQ(
      drive.run(10, [](Situation& now) { now.last_scan = poses::later(kStart, 1); }),
      Conduct::stop);
  EXPECT_EQ(
      drive.supervisor.log().back().text,
      "no newer scan in the maps for 0.55 s (max_map_age_s = 0.5)");
  EXPECT_EQ(drive.run(1), Conduct::drive);
  EXPECT_EQ(drive.told(), "drive, stop stale_map, drive");
}

TEST(Supervisor, StopsForStalePoses)
{
  SupervisedDrive drive;
  drive.run(1);
  EXPECT_EQ(
      drive.run(5, [](Situation& now) { now.last_pose = poses::later(kStart, 1); }), Conduct::stop);
  drive.run(1);
  EXPECT_EQ(drive.told(), "drive, stop stale_pose, drive");
}

TEST(Supervisor, StopsBeforeTheFirstScan)
{
  SupervisedDrive drive;
  EXPECT_EQ(drive.run(1, [](Situation& now) { now.last_scan = 0; }), Conduct::stop);
  EXPECT_EQ(drive.told(), "stop stale_map");
}

TEST(Supervisor, StopsWhereThePoseJumpsUntilItHasBeenSteady)
{
  SupervisedDrive drive;
  drive.run(2);
  const auto shifted = [](Situation& now) { now.pose.y_m = 3; };
  EXPECT_EQ(drive.run(0.95, shifted), Conduct::stop);
  EXPECT_EQ(drive.run(0.1, shifted), Conduct::drive);
  EXPECT_EQ(drive.told(), "drive, stop lost_pose, drive");
  EXPECT_EQ(drive.supervisor.log()[1].text, "the pose jumped by 3 m (max_pose_jump_m = 1)");
}

TEST(Supervisor, StaysStoppedWhilePosesJumpOn)
{
  SupervisedDrive drive;
  int n = 0;
  EXPECT_EQ(
      drive.run(10, [&](Situation& now) { now.pose.y_m = ++n % 10 < 5 ? 3 : -3; }), Conduct::stop);
}

TEST(Supervisor, TakesFastDrivesForNoJumps)
{
  SupervisedDrive drive;
  double speed_mps = 0;
  double x_m = 0;
  drive.run(
      20,
      [&](Situation& now)
      {
        speed_mps = std::min(40.0, speed_mps + 0.25);  // 2 m a step in the end
        x_m += speed_mps * kStep_s;
        now.pose.x_m = x_m;
      });
  EXPECT_EQ(drive.told(), "drive");
}

TEST(Supervisor, TakesAPoseThatIsNoneForLost)
{
  SupervisedDrive drive;
  drive.run(1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(drive.run(1, [&](Situation& now) { now.pose.yaw_rad = nan; }), Conduct::stop);
  EXPECT_EQ(drive.run(0.5), Conduct::stop);
  EXPECT_EQ(drive.run(1), Conduct::drive);
}

TEST(Supervisor, ArrivesAndGoesOnToTheNextGoal)
{
  SupervisedDrive drive;
  drive.run(1);
  EXPECT_EQ(drive.run(1, [](Situation& now) { now.to_goal_m = 0.5; }), Conduct::arrived);
  EXPECT_EQ(drive.run(1), Conduct::arrived);
  drive.supervisor.nextGoal();
  EXPECT_EQ(drive.run(1), Conduct::drive);
  EXPECT_EQ(drive.told(), "drive, arrived arrived, drive");
}

TEST(Supervisor, RefusesLimitsOutOfRange)
{
  WatchdogParams params;
  params.no_way_s = -1;
  EXPECT_THROW(Supervisor(params, kTolerance_m), options::OptionError);
}
}  // namespace
