// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/navigation/supervisor.h>

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace
{
using namespace traverse;
using namespace traverse::navigation;

constexpr poses::TimeNs kStart = 1'600'000'000'000'000'000;
constexpr double kStep_s = 0.05;
constexpr double kTolerance_m = 0.5;

/** A vehicle that drives along x at 1 m/s and steps its supervisor at 20 Hz, all being well. */
class Drive
{
 public:
  explicit Drive(const WatchdogParams& params = {}) : supervisor(params, kTolerance_m) {}

  /** change(Situation&) is told each step's situation before the supervisor is. */
  template <class F>
  Conduct run(double seconds, F&& change)
  {
    Conduct conduct = Conduct::stop;
    const int steps = static_cast<int>(seconds / kStep_s + 0.5);
    for (int i = 0; i < steps; ++i)
    {
      time_s_ += kStep_s;
      Situation now;
      now.now = poses::later(kStart, time_s_);
      now.last_scan = now.last_pose = now.now;
      now.pose.x_m = time_s_;
      now.has_way = now.has_motion = now.wants_motion = true;
      now.to_goal_m = 100;
      change(now);
      conduct = supervisor.step(now);
    }
    return conduct;
  }

  Conduct run(double seconds)
  {
    return run(seconds, [](Situation&) {});
  }

  /** "drive, stop stale_map, ..." */
  std::string told() const
  {
    std::string text;
    for (const Decision& decision : supervisor.log())
    {
      text += (text.empty() ? "" : ", ") + std::string(nameOf(decision.conduct));
      text += decision.cause == Cause::none ? "" : " " + std::string(nameOf(decision.cause));
    }
    return text;
  }

  /** Of the last decision, s after the beginning. */
  double lastTime_s() const { return poses::secondsBetween(kStart, supervisor.log().back().time); }

  Supervisor supervisor;

 private:
  double time_s_ = 0;
};

TEST(Supervisor, DrivesWhileAllIsWell)
{
  Drive drive;
  EXPECT_EQ(drive.run(60), Conduct::drive);
  EXPECT_EQ(drive.told(), "drive");
}

TEST(Supervisor, StopsForStaleMapsAndDrivesOnWithNewOnes)
{
  Drive drive;
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
  Drive drive;
  drive.run(1);
  EXPECT_EQ(
      drive.run(5, [](Situation& now) { now.last_pose = poses::later(kStart, 1); }), Conduct::stop);
  drive.run(1);
  EXPECT_EQ(drive.told(), "drive, stop stale_pose, drive");
}

TEST(Supervisor, StopsBeforeTheFirstScan)
{
  Drive drive;
  EXPECT_EQ(drive.run(1, [](Situation& now) { now.last_scan = 0; }), Conduct::stop);
  EXPECT_EQ(drive.told(), "stop stale_map");
}

TEST(Supervisor, StopsWhereThePoseJumpsUntilItHasBeenSteady)
{
  Drive drive;
  drive.run(2);
  const auto shifted = [](Situation& now) { now.pose.y_m = 3; };
  EXPECT_EQ(drive.run(0.95, shifted), Conduct::stop);
  EXPECT_EQ(drive.run(0.1, shifted), Conduct::drive);
  EXPECT_EQ(drive.told(), "drive, stop lost_pose, drive");
  EXPECT_EQ(drive.supervisor.log()[1].text, "the pose jumped by 3 m (max_pose_jump_m = 1)");
}

TEST(Supervisor, StaysStoppedWhilePosesJumpOn)
{
  Drive drive;
  int n = 0;
  EXPECT_EQ(
      drive.run(10, [&](Situation& now) { now.pose.y_m = ++n % 10 < 5 ? 3 : -3; }), Conduct::stop);
}

TEST(Supervisor, TakesFastDrivesForNoJumps)
{
  Drive drive;
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
  Drive drive;
  drive.run(1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(drive.run(1, [&](Situation& now) { now.pose.yaw_rad = nan; }), Conduct::stop);
  EXPECT_EQ(drive.run(0.5), Conduct::stop);
  EXPECT_EQ(drive.run(1), Conduct::drive);
}

TEST(Supervisor, GivesUpWithoutAWayWithinThreeSeconds)
{
  Drive drive;
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
}

TEST(Supervisor, DrivesOnWhereAWayIsFoundInTime)
{
  Drive drive;
  drive.run(5);
  EXPECT_EQ(drive.run(1.5, [](Situation& now) { now.has_way = false; }), Conduct::stop);
  EXPECT_EQ(drive.run(1), Conduct::drive);
  EXPECT_EQ(drive.run(1.5, [](Situation& now) { now.has_way = false; }), Conduct::stop);
  EXPECT_EQ(drive.run(1), Conduct::drive);
}

TEST(Supervisor, DoesNotCountTheTimeWithoutSensesAsWithoutAWay)
{
  Drive drive;
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

TEST(Supervisor, SaysThatTheGoalIsBlocked)
{
  Drive drive;
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

TEST(Supervisor, DrivesTowardsABlockedGoalWhileThereIsAWay)
{
  Drive drive;
  EXPECT_EQ(drive.run(5, [](Situation& now) { now.is_goal_blocked = true; }), Conduct::drive);
}

TEST(Supervisor, BacksOffWhereItIsBlockedAndGivesUpInTheEnd)
{
  WatchdogParams params;
  params.most_recoveries = 2;
  Drive drive(params);
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

TEST(Supervisor, DrivesOnAfterARecoveryThatHelped)
{
  Drive drive;
  drive.run(1);
  drive.run(1.2, [](Situation& now) { now.has_motion = false; });
  EXPECT_EQ(drive.run(1), Conduct::recover);
  EXPECT_EQ(drive.run(1), Conduct::drive);
  EXPECT_EQ(drive.told(), "drive, stop blocked, recover blocked, drive");
}

TEST(Supervisor, DoesNotBackOffFromABlockedGoal)
{
  Drive drive;
  drive.run(
      3,
      [](Situation& now)
      {
        now.has_motion = false;
        now.is_goal_blocked = true;
      });
  EXPECT_EQ(drive.told(), "stop goal_in_obstacle, give_up goal_in_obstacle");
}

TEST(Supervisor, TakesACommandToStandForBlocked)
{
  Drive drive;
  drive.run(1.5, [](Situation& now) { now.wants_motion = false; });
  EXPECT_EQ(drive.told(), "stop blocked, recover blocked");
}

TEST(Supervisor, BacksOffWhereItIsStuck)
{
  WatchdogParams params;
  params.most_recoveries = 1;
  Drive drive(params);
  drive.run(1);
  drive.run(30, [](Situation& now) { now.pose.x_m = 1; });
  EXPECT_EQ(drive.told(), "drive, recover stuck, drive, give_up stuck");
  EXPECT_EQ(
      drive.supervisor.log().back().text,
      "came no further than 0.1 m in 4 s (stuck_s = 4), after 1 recoveries");
}

TEST(Supervisor, TakesTurningForGettingOnAndWobblingNot)
{
  Drive turning;
  turning.run(
      30,
      [](Situation& now) {
        now.pose = {1, 0, 0.35 * poses::secondsBetween(kStart, now.now)};
      });
  EXPECT_EQ(turning.told(), "drive");
  Drive wobbling;
  int n = 0;
  wobbling.run(6, [&](Situation& now) { now.pose = {1, 0, ++n % 20 < 10 ? 0.4 : -0.4}; });
  EXPECT_EQ(wobbling.told(), "drive, recover stuck, drive");
}

TEST(Supervisor, ArrivesAndGoesOnToTheNextGoal)
{
  Drive drive;
  drive.run(1);
  EXPECT_EQ(drive.run(1, [](Situation& now) { now.to_goal_m = 0.5; }), Conduct::arrived);
  EXPECT_EQ(drive.run(1), Conduct::arrived);
  drive.supervisor.nextGoal();
  EXPECT_EQ(drive.run(1), Conduct::drive);
  EXPECT_EQ(drive.told(), "drive, arrived arrived, drive");
}

TEST(Supervisor, StopsForItsSensesWhileItBacksOff)
{
  Drive drive;
  drive.run(1.2, [](Situation& now) { now.has_motion = false; });
  EXPECT_EQ(drive.run(0.1, [](Situation& now) { now.last_pose = kStart; }), Conduct::stop);
}

TEST(Supervisor, RefusesLimitsOutOfRange)
{
  WatchdogParams params;
  params.no_way_s = -1;
  EXPECT_THROW(Supervisor(params, kTolerance_m), options::OptionError);
}
}  // namespace
