// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <support/supervised_drive.h>

namespace
{
using namespace traverse;
using namespace traverse::navigation;
using namespace traverse::testing;

TEST(SupervisorRecovery, GivesUpWithoutAWayWithinThreeSeconds)
{
  SupervisedDrive drive;
  drive.run(5);
  drive.run(3, [](Situation& now) { now.has_way = false; });
  EXPECT_EQ(drive.told(), "drive, stop no_way, give_up no_way");
  EXPECT_LE(drive.lastTime_s(), 8);
  EXPECT_EQ(
      drive.supervisor.log().back().text,
      "there is no way, 100 m from the goal, for 2 s (no_way_s = 2)");
  // For good.
  EXPECT_EQ(drive.run(5), Conduct::give_up);
  drive.supervisor.nextGoal();
  EXPECT_EQ(drive.run(5), Conduct::give_up);
  // But for another mission.
  drive.supervisor.startOver();
  EXPECT_EQ(drive.run(1), Conduct::drive);
}

TEST(SupervisorRecovery, DrivesOnWhereAWayIsFoundInTime)
{
  SupervisedDrive drive;
  drive.run(5);
  EXPECT_EQ(drive.run(1.5, [](Situation& now) { now.has_way = false; }), Conduct::stop);
  EXPECT_EQ(drive.run(1), Conduct::drive);
  EXPECT_EQ(drive.run(1.5, [](Situation& now) { now.has_way = false; }), Conduct::stop);
  EXPECT_EQ(drive.run(1), Conduct::drive);
}

TEST(SupervisorRecovery, DoesNotCountTheTimeWithoutSensesAsWithoutAWay)
{
  SupervisedDrive drive;
  drive.run(1.5, [](Situation& now) { now.has_way = false; });
  drive.run(
      10,
      [](Situation& now)
      {
        now.has_way = false;
        now.last_scan = kStart;
      });
  EXPECT_EQ(drive.run(1.5, [](Situation& now) { now.has_way = false; }), Conduct::stop);
}

TEST(SupervisorRecovery, SaysThatTheGoalIsBlocked)
{
  SupervisedDrive drive;
  drive.run(1);
  drive.run(
      3,
      [](Situation& now)
      {
        now.has_way = false;
        now.is_goal_blocked = true;
      });
  EXPECT_EQ(drive.told(), "drive, stop goal_in_obstacle, give_up goal_in_obstacle");
}

TEST(SupervisorRecovery, DrivesTowardsABlockedGoalWhileThereIsAWay)
{
  SupervisedDrive drive;
  EXPECT_EQ(drive.run(5, [](Situation& now) { now.is_goal_blocked = true; }), Conduct::drive);
}

TEST(SupervisorRecovery, BacksOffWhereItIsBlockedAndGivesUpInTheEnd)
{
  WatchdogParams params;
  params.most_recoveries = 2;
  SupervisedDrive drive(params);
  drive.run(1);
  drive.run(30, [](Situation& now) { now.has_motion = false; });
  EXPECT_EQ(
      drive.told(),
      "drive, stop blocked, recover blocked, stop blocked, recover blocked, stop blocked, "
      "give_up blocked");
  EXPECT_EQ(drive.supervisor.recoveries(), 2);
  // Twice 1 s of waiting and 1.5 s of backing off, then 2 s; a step more each time.
  EXPECT_NEAR(drive.lastTime_s(), 1 + 2 * 2.5 + 2, 6 * kStep_s);
}

TEST(SupervisorRecovery, DrivesOnAfterARecoveryThatHelped)
{
  SupervisedDrive drive;
  drive.run(1);
  drive.run(1.2, [](Situation& now) { now.has_motion = false; });
  EXPECT_EQ(drive.run(1), Conduct::recover);
  EXPECT_EQ(drive.run(1), Conduct::drive);
  EXPECT_EQ(drive.told(), "drive, stop blocked, recover blocked, drive");
}

TEST(SupervisorRecovery, DoesNotBackOffFromABlockedGoal)
{
  SupervisedDrive drive;
  drive.run(
      3,
      [](Situation& now)
      {
        now.has_motion = false;
        now.is_goal_blocked = true;
      });
  EXPECT_EQ(drive.told(), "stop goal_in_obstacle, give_up goal_in_obstacle");
}

TEST(SupervisorRecovery, TakesACommandToStandForBlocked)
{
  SupervisedDrive drive;
  drive.run(1.5, [](Situation& now) { now.wants_motion = false; });
  EXPECT_EQ(drive.told(), "stop blocked, recover blocked");
}

TEST(SupervisorRecovery, BacksOffWhereItIsStuck)
{
  WatchdogParams params;
  params.most_recoveries = 1;
  SupervisedDrive drive(params);
  drive.run(1);
  drive.run(30, [](Situation& now) { now.pose.x_m = 1; });
  EXPECT_EQ(drive.told(), "drive, recover stuck, drive, give_up stuck");
  EXPECT_EQ(
      drive.supervisor.log().back().text,
      "came no further than 0.1 m in 4 s (stuck_s = 4), after 1 recoveries");
}

TEST(SupervisorRecovery, TakesTurningForGettingOnAndWobblingNot)
{
  SupervisedDrive turning;
  turning.run(
      30,
      [](Situation& now) {
        now.pose = {1, 0, 0.35 * poses::secondsBetween(kStart, now.now)};
      });
  EXPECT_EQ(turning.told(), "drive");
  SupervisedDrive wobbling;
  int n = 0;
  wobbling.run(6, [&](Situation& now) { now.pose = {1, 0, ++n % 20 < 10 ? 0.4 : -0.4}; });
  EXPECT_EQ(wobbling.told(), "drive, recover stuck, drive");
}

TEST(SupervisorRecovery, StopsForItsSensesWhileItBacksOff)
{
  SupervisedDrive drive;
  drive.run(1.2, [](Situation& now) { now.has_motion = false; });
  EXPECT_EQ(drive.run(0.1, [](Situation& now) { now.last_pose = kStart; }), Conduct::stop);
}
}  // namespace
