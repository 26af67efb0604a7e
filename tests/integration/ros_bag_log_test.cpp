// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationGPS.h>
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <support/mrpt_round_trip.h>
#include <support/ros_bag.h>

namespace
{
using namespace traverse;
using namespace traverse::testing;
using namespace mrpt::obs;
using importing::ImportError;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Pair;
using ::testing::SizeIs;

TEST(RosBagLog, OdometryInThePlaneKeepsItsVelocity)
{
  BagFile bag;
  bag.write("/odom", 0, rosOdometry(0, 3, 0));
  const auto odometry = throughALog(*observationOf<CObservationOdometry>(readBag(bag)));
  EXPECT_EQ(odometry->odometry.x(), 3);
  EXPECT_TRUE(odometry->hasVelocities);
  EXPECT_EQ(odometry->velocityLocal.vx, 1.5);
  EXPECT_EQ(odometry->velocityLocal.omega, 0.25);
}

TEST(RosBagLog, OdometryThatLeavesThePlaneIsARobotPoseFromItsFirstMessageOn)
{
  BagFile bag;
  bag.writeTf(rosTransform(0, "base_link", "velodyne", 2, 0));
  bag.write("/odom", 0, rosOdometry(0, 0, 0));
  auto second = rosOdometry(1, 3, 0.5);
  second.child_frame_id = "velodyne";
  bag.write("/odom", 1, second);
  const BagReading r = readBag(bag);
  EXPECT_THAT(r.report.imported, ElementsAre(Pair("odom CObservationRobotPose", 2)));
  const auto pose = throughALog(*observationOf<CObservationRobotPose>(r, 1));
  EXPECT_EQ(pose->pose.mean.z(), 0.5);
  EXPECT_EQ(pose->sensorPose.x(), 2);
  EXPECT_EQ(pose->pose.cov(0, 1), 1);
  EXPECT_EQ(pose->pose.cov(0, 3), 5) << "turn about z is yaw";
  EXPECT_EQ(pose->pose.cov(5, 5), 21) << "turn about x is roll";
}

TEST(RosBagLog, GivesImuAndFixes)
{
  msgs::Imu imu;
  imu.header = rosHeader(0, "imu");
  imu.orientation.z = std::sin(0.25);
  imu.orientation.w = std::cos(0.25);
  imu.linear_acceleration.z = 9.8;
  imu.angular_velocity_covariance[0] = -1;
  msgs::NavSatFix fix;
  fix.header = rosHeader(0.5, "gps");
  fix.latitude = 36.7;
  fix.longitude = -4.5;
  fix.altitude = 60;
  msgs::NavSatFix none = fix;
  none.status.status = -1;
  BagFile bag;
  bag.write("/imu", 0, imu);
  bag.write("/fix", 0.5, fix);
  bag.write("/fix", 0.6, none);
  const BagReading r = readBag(bag);
  const auto got = throughALog(*observationOf<CObservationIMU>(r));
  EXPECT_EQ(got->get(IMU_Z_ACC), 9.8);
  EXPECT_NEAR(got->get(IMU_YAW), 0.5, 1e-9);
  EXPECT_FALSE(got->has(IMU_WZ));
  const auto gps = throughALog(*observationOf<CObservationGPS>(r));
  const auto& gga = gps->getMsgByClass<gnss::Message_NMEA_GGA>().fields;
  EXPECT_EQ(gga.latitude_degrees, 36.7);
  EXPECT_EQ(gga.longitude_degrees, -4.5);
  EXPECT_EQ(gga.altitude_meters, 60);
  EXPECT_THAT(r.report.skipped, Contains(Pair(HasSubstr("no fix"), 1)));
}

TEST(RosBagLog, StampsOrderTheLogAndZeroOnesAreTheRecordings)
{
  BagFile bag;
  bag.write("/a", 0.5, rosLaser(0.4, 5));
  bag.write("/b", 0.6, rosLaser(0.2, 5));
  auto zero = rosLaser(0, 5);
  zero.header.stamp = ros::Time();
  bag.write("/c", 0.3, zero);
  const BagReading r = readBag(bag);
  std::vector<std::string> labels;
  for (const importing::Entry& entry : r.entries)
  {
    labels.push_back(entry.observation->sensorLabel);
  }
  EXPECT_THAT(labels, ElementsAre("b", "c", "a"));
  EXPECT_NEAR(mrpt::Clock::toDouble(r.entries[1].observation->timestamp), kBagStart_s + 0.3, 1e-6);
  EXPECT_THAT(r.report.skipped, Contains(Pair(HasSubstr("/c: stamps (0"), 1)));
}

TEST(RosBagLog, ASimulatorsStampsBecomeAClocks)
{
  auto laser = rosLaser(0, 5);
  laser.header.stamp = ros::Time(12.5);
  BagFile bag;
  bag.write("/scan", 12.5 - kBagStart_s, laser);
  const BagReading r = readBag(bag);
  EXPECT_NEAR(mrpt::Clock::toDouble(r.entries.at(0).observation->timestamp), 946684812.5, 1e-6);
  EXPECT_THAT(r.report.warnings, Contains(HasSubstr("2000-01-01")));
}

TEST(RosBagLog, UnknownTypesAndFramesAreTold)
{
  BagFile bag;
  bag.writeTf(rosTransform(0, "base_link", "elsewhere", 1, 0));
  bag.write("/scan", 0, rosLaser(0, 5));
  bag.write("/goal\n", 0, msgs::Vector3());
  bag.write("/goal\n", 1, msgs::Vector3());
  const BagReading r = readBag(bag);
  EXPECT_THAT(r.report.skipped, ElementsAre(Pair("/goal?: its type geometry_msgs/Vector3", 2)));
  EXPECT_THAT(r.report.warnings, Contains(HasSubstr("does not join frame 'laser'")));
  EXPECT_EQ(observationOf<CObservation2DRangeScan>(r)->sensorPose.x(), 0);
}

TEST(RosBagLog, OnlyTopicsAskedForAndABaseOfChoice)
{
  BagFile bag;
  bag.writeTf(rosTransform(0, "base_link", "laser", 1, 0));
  bag.writeTf(rosTransform(0, "chassis", "base_link", 10, 0));
  bag.write("/scan", 0, rosLaser(0, 5));
  bag.write("/other", 0, rosLaser(0, 5));
  ros_bags::BagParams params;
  params.topics = "/scan";
  params.base_frame = "chassis";
  const BagReading r = readBag(bag, params);
  EXPECT_THAT(r.entries, SizeIs(1));
  EXPECT_EQ(observationOf<CObservation2DRangeScan>(r)->sensorPose.x(), 11);
  EXPECT_THAT(r.report.skipped, ElementsAre(Pair("/other: not asked for", 1)));
}

TEST(RosBagLog, HostileTopicsBecomePlainLabels)
{
  BagFile bag;
  bag.write("/../../etc/pass wd", 0, rosLaser(0, 5));
  bag.write("/a/b", 1, rosLaser(1, 5));
  bag.write("/a_b", 2, rosLaser(2, 5));
  const BagReading r = readBag(bag);
  ASSERT_THAT(r.entries, SizeIs(3));
  const std::string first = r.entries[0].observation->sensorLabel;
  EXPECT_EQ(first.find_first_of("/ \n"), std::string::npos) << first;
  EXPECT_NE(r.entries[1].observation->sensorLabel, r.entries[2].observation->sensorLabel);
}

TEST(RosBagLog, ThatIsNoneIsRefusedByName)
{
  const ScratchFolder dir;
  writeText(dir / "x.bag", "hello");
  EXPECT_FALSE(ros_bags::looksLikeBag(dir / "x.bag"));
  EXPECT_FALSE(ros_bags::looksLikeBag(dir / "missing.bag"));
  EXPECT_THROW(readBag(dir / "x.bag"), ImportError);
  EXPECT_THROW(readBag(dir / "missing.bag"), ImportError);
  EXPECT_THROW(readBag(dir.path()), ImportError);
  BagFile bag;
  bag.write("/scan", 0, rosLaser(0, 5));
  bag.bytes();
  EXPECT_TRUE(ros_bags::looksLikeBag(bag.path()));
}
}  // namespace
