// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/logs/log_poses.h>

#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <support/data.h>
#include <support/log_reading.h>

namespace
{
using namespace traverse;
using namespace traverse::logs;
using poses::PoseSource;
using traverse::testing::kLogStart;
using traverse::testing::laserScan;
using traverse::testing::mrptData;
using traverse::testing::serialised;

const char* const kSena = "2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog";

PoseReading posesOf(const std::string& bytes, PoseSource source)
{
  const traverse::testing::ScratchFolder dir;
  traverse::testing::writeText(dir / "some.rawlog", bytes);
  return readLogPoses(dir / "some.rawlog", source, {}, {});
}

double pathLength(const std::vector<poses::StampedPose>& path)
{
  double sum = 0;
  for (size_t i = 1; i < path.size(); ++i)
  {
    sum += (path[i].T_map_base.translation() - path[i - 1].T_map_base.translation()).norm();
  }
  return sum;
}

mrpt::obs::CActionRobotMovement2D step(double x, double phi)
{
  mrpt::obs::CActionRobotMovement2D action;
  action.computeFromOdometry(mrpt::poses::CPose2D(x, 0, phi), {});
  action.timestamp = INVALID_TIMESTAMP;
  return action;
}

std::string frameAt(double t_s)
{
  mrpt::obs::CSensoryFrame frame;
  frame.insert(std::make_shared<mrpt::obs::CObservation2DRangeScan>(laserScan(t_s)));
  return serialised(frame);
}

/** An action and the frame that it led to. */
std::string pairOf(const mrpt::obs::CActionRobotMovement2D& action, double t_s)
{
  mrpt::obs::CActionCollection actions;
  actions.insert(action);
  return serialised(actions) + frameAt(t_s);
}

TEST(LogPoses, OdometryOfTheSenaLogIsMrptsOwn)
{
  const std::string file = mrptData(kSena);
  TRAVERSE_NEEDS(file);
  const PoseReading r = readLogPoses(file, PoseSource::odometry, {}, {});
  EXPECT_TRUE(r.report.complete()) << r.report.damage;
  EXPECT_EQ(r.poses.size(), 225U);
  EXPECT_NEAR(pathLength(r.poses), 76.4, 0.1);
  mrpt::obs::CRawlog log;
  ASSERT_TRUE(log.loadFromRawLogFile(file));
  mrpt::poses::CPose3D expected;
  for (size_t i = 0; i < log.size(); ++i)
  {
    if (log.getType(i) == mrpt::obs::CRawlog::etActionCollection)
    {
      mrpt::poses::CPose3D increment;
      log.getAsAction(i)->getFirstMovementEstimationMean(increment);
      expected = expected + increment;
    }
  }
  const Eigen::Vector3d end = r.poses.back().T_map_base.translation();
  // 224 increments, each with its rotation rounded to 2^-40, over 76 m.
  EXPECT_NEAR(end.x(), expected.x(), 1e-6);
  EXPECT_NEAR(end.y(), expected.y(), 1e-6);
}

TEST(LogPoses, EveryScanOfPairsHasAPoseOfItsOwnStamp)
{
  for (const char* name : {kSena, "localization_demo.rawlog", "uwb_ro-localization_demo.rawlog"})
  {
    const std::string file = mrptData(name);
    TRAVERSE_NEEDS(file);
    std::set<poses::TimeNs> stamps;
    for (const auto& pose : readLogPoses(file, PoseSource::odometry, {}, {}).poses)
    {
      stamps.insert(pose.time);
    }
    for (const points::Decoded& scan : traverse::testing::readLog(file).scans)
    {
      EXPECT_EQ(stamps.count(scan.scan.stamp), 1U) << name;
    }
  }
}

TEST(LogPoses, IncrementsArePutTogetherAndStampedByTheirFrame)
{
  std::string log;
  for (int i = 0; i < 4; ++i)
  {
    log += pairOf(step(2, std::numbers::pi / 2), i);
  }
  const PoseReading r = posesOf(log, PoseSource::odometry);
  ASSERT_EQ(r.poses.size(), 4U);
  EXPECT_EQ(r.poses[1].time, kLogStart + 1'000'000'000);
  // Two metres, a quarter turn, four times: a square. Rotations are kept to 2^-40.
  EXPECT_NEAR(r.poses[1].T_map_base.translation().x(), 2, 1e-9);
  EXPECT_NEAR(r.poses[1].T_map_base.translation().y(), 2, 1e-9);
  EXPECT_NEAR(r.poses[3].T_map_base.translation().norm(), 0, 1e-9);
}

TEST(LogPoses, FramesWithoutAnyMovementAreNoOdometry)
{
  EXPECT_TRUE(posesOf(frameAt(0) + frameAt(1), PoseSource::odometry).poses.empty());
  const PoseReading moved = posesOf(frameAt(0) + pairOf(step(2, 0), 1), PoseSource::odometry);
  ASSERT_EQ(moved.poses.size(), 2U) << "the frame before the first movement is where it began";
  EXPECT_NEAR(moved.poses[0].T_map_base.translation().x(), 0, 1e-12);
  EXPECT_NEAR(moved.poses[1].T_map_base.translation().x(), 2, 1e-9);
}

TEST(LogPoses, SpeedsAndTicksOfAnActionAreSkippedRight)
{
  auto action = step(1, 0);
  std::string log = pairOf(action, 0);
  action.hasVelocities = true;
  log += pairOf(action, 1);
  action.hasEncodersInfo = true;
  log += pairOf(action, 2);
  action.estimationMethod = mrpt::obs::CActionRobotMovement2D::emScan2DMatching;
  log += pairOf(action, 3);
  const PoseReading r = posesOf(log, PoseSource::odometry);
  EXPECT_TRUE(r.report.complete()) << r.report.damage;
  ASSERT_EQ(r.poses.size(), 4U);
  EXPECT_NEAR(r.poses[3].T_map_base.translation().x(), 4, 1e-9);
}

TEST(LogPoses, NoParticlesAreDrawnHoweverManyTheFileAsksFor)
{
  mrpt::obs::CActionRobotMovement2D action;
  mrpt::obs::CActionRobotMovement2D::TMotionModelOptions model;
  model.modelSelection = mrpt::obs::CActionRobotMovement2D::mmThrun;
  model.thrunModel.nParticlesCount = 7654;
  action.computeFromOdometry(mrpt::poses::CPose2D(1, 0, 0), model);
  std::string log = pairOf(action, 0);
  const size_t at = log.find(std::string("\xe6\x1d\0\0", 4));
  ASSERT_NE(at, std::string::npos);
  log.replace(at, 4, "\xff\xff\xff\x7f");
  const PoseReading r = posesOf(log, PoseSource::odometry);
  EXPECT_TRUE(r.report.complete()) << r.report.damage;
  EXPECT_EQ(r.poses.size(), 1U);
}

TEST(LogPoses, AbsoluteOdometryIsTakenAsItStands)
{
  std::string log;
  for (int i = 0; i < 3; ++i)
  {
    mrpt::obs::CObservationOdometry odometry;
    odometry.timestamp = laserScan(i).timestamp;
    odometry.odometry = mrpt::poses::CPose2D(100 + i, 5, 0.1);
    log += serialised(odometry) + serialised(laserScan(i));
  }
  const PoseReading r = posesOf(log, PoseSource::odometry);
  ASSERT_EQ(r.poses.size(), 3U);
  EXPECT_NEAR(r.poses[2].T_map_base.translation().x(), 102, 1e-9);
  EXPECT_EQ(r.report.ignored.at("CObservation2DRangeScan"), 3U);
}

TEST(LogPoses, RobotPosesAreThoseOfTheVehicleNotOfTheirSensor)
{
  mrpt::obs::CObservationRobotPose pose;
  pose.timestamp = laserScan(0).timestamp;
  pose.pose.mean = mrpt::poses::CPose3D(10, 5, 2, std::numbers::pi / 2, 0, 0);
  pose.sensorPose = mrpt::poses::CPose3D(1, 0, 0.5, 0, 0, 0);
  auto without_stamp = pose;
  without_stamp.timestamp = INVALID_TIMESTAMP;
  const PoseReading r =
      posesOf(serialised(pose) + serialised(without_stamp), PoseSource::robot_pose);
  ASSERT_EQ(r.poses.size(), 1U);
  const Eigen::Vector3d at = r.poses[0].T_map_base.translation();
  EXPECT_NEAR(at.x(), 10, 1e-9);
  EXPECT_NEAR(at.y(), 4, 1e-9) << "the sensor sits 1 m ahead of the vehicle, which looks along y";
  EXPECT_NEAR(at.z(), 1.5, 1e-9);
  EXPECT_EQ(r.report.bad_stamps, 1U);
}

TEST(LogPoses, IcpKeepsToTheWayThatTheOdometrySays)
{
  const std::string file = mrptData("localization_demo.rawlog");
  TRAVERSE_NEEDS(file);
  const PoseReading r = readLogPoses(file, PoseSource::icp_2d, {}, {});
  EXPECT_TRUE(r.report.complete()) << r.report.damage;
  ASSERT_EQ(r.poses.size(), 37U);
  // The odometry says 12.76 m, and is a simulated one with noise.
  EXPECT_NEAR(pathLength(r.poses), 12.76, 1.3);
}

TEST(LogPoses, IcpLeavesUselessScansOut)
{
  auto nonsense = laserScan(0);
  for (size_t i = 0; i < nonsense.getScanSize(); ++i)
  {
    nonsense.setScanRange(i, i % 2 == 0 ? -INFINITY : NAN);
  }
  auto one_beam = laserScan(1);
  one_beam.resizeScanAndAssign(1, 5, true);
  auto tilted = laserScan(2);
  tilted.sensorPose = mrpt::poses::CPose3D(0, 0, 0, 0, 1, 0);
  const PoseReading r = posesOf(
      serialised(nonsense) + serialised(one_beam) + serialised(tilted) + serialised(laserScan(3)),
      PoseSource::icp_2d);
  EXPECT_TRUE(r.report.complete()) << r.report.damage;
  EXPECT_EQ(r.poses.size(), 2U);
  EXPECT_EQ(r.report.rejected.begin()->second, 2U);
}

TEST(LogPoses, SourcesThatAreNoPartOfALogAreRefused)
{
  EXPECT_THROW(posesOf("x", PoseSource::identity), std::invalid_argument);
  EXPECT_THROW(posesOf("x", PoseSource::file), std::invalid_argument);
}
}  // namespace
