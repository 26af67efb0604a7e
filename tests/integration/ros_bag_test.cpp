// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/observations/to_scan.h>

#include <mrpt/io/CMemoryStream.h>
#include <mrpt/maps/CColouredPointsMap.h>
#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/maps/registerAllClasses.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationGPS.h>
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CObservationImage.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/serialization/CArchive.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
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
using ::testing::IsEmpty;
using ::testing::Key;
using ::testing::Pair;
using ::testing::SizeIs;
using ::testing::UnorderedElementsAre;

constexpr double kHalfPi = 1.5707963267948966;

/** What a program that reads the log would have. */
template <class T>
std::shared_ptr<T> throughALog(const T& observation)
{
  mrpt::maps::registerAllClasses_mrpt_maps();
  mrpt::io::CMemoryStream stream;
  auto archive = mrpt::serialization::archiveFrom(stream);
  archive << observation;
  stream.Seek(0);
  return std::dynamic_pointer_cast<T>(archive.ReadObject());
}

/** Lidar 2 m ahead of the vehicle, turned to the left. */
void writeLidarTf(BagFile& bag)
{
  bag.writeTf(rosTransform(0, "base_link", "velodyne", 2, kHalfPi));
}

void expectVelodyne(const BagReading& r, size_t clouds)
{
  EXPECT_THAT(r.report.damage, IsEmpty());
  EXPECT_THAT(r.report.warnings, IsEmpty());
  EXPECT_THAT(
      r.report.imported, ElementsAre(Pair("velodyne_points CObservationPointCloud", clouds)));
  for (const importing::Entry& entry : r.entries)
  {
    EXPECT_THAT(entry.channels.ring, SizeIs(500));
    EXPECT_THAT(entry.channels.time_s, SizeIs(500));
  }
}

TEST(RosBag, GivesCloudsWithIntensityRingTimeAndPose)
{
  BagFile bag;
  writeLidarTf(bag);
  bag.write("/velodyne_points", 1.05, velodyneCloud(1, 500, 10));
  const BagReading r = readBag(bag);
  expectVelodyne(r, 1);
  const auto cloud = throughALog(*observationOf<CObservationPointCloud>(r));
  EXPECT_EQ(cloud->sensorLabel, "velodyne_points");
  EXPECT_EQ(mrpt::Clock::toDouble(cloud->timestamp), kBagStart_s + 1.0);
  EXPECT_EQ(cloud->sensorPose.x(), 2);
  EXPECT_NEAR(cloud->sensorPose.yaw(), kHalfPi, 1e-12);
  const auto& map = dynamic_cast<const mrpt::maps::CPointsMapXYZI&>(*cloud->pointcloud);
  ASSERT_EQ(map.size(), 500U);
  EXPECT_EQ(map.getPointIntensity(51), 51 / 255.0F);
  EXPECT_EQ(r.entries[0].channels.ring[17], 1);
  const auto scan = observations::toScan(*cloud, {});
  EXPECT_EQ(scan.outcome, observations::Outcome::scan);
  EXPECT_EQ(scan.decoded.scan.size(), 500U);
}

TEST(RosBag, OfEachCompressionGivesTheSame)
{
  using namespace rosbag::compression;
  for (const auto compression : {Uncompressed, BZ2, LZ4})
  {
    BagFile bag(compression, 4096);
    writeLidarTf(bag);
    for (int i = 0; i < 20; ++i)
    {
      bag.write("/velodyne_points", i, velodyneCloud(i, 500, 10));
    }
    SCOPED_TRACE(compression);
    expectVelodyne(readBag(bag), 20);
  }
}

TEST(RosBag, PointsThatAreNoneStayAndAreCountedByTheDecoder)
{
  auto cloud = velodyneCloud(0, 500, 10);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(cloud.data.data(), &nan, sizeof(nan));
  std::fill_n(cloud.data.begin() + cloud.point_step, 12, uint8_t{0});
  BagFile bag;
  bag.write("/points", 0, cloud);
  const BagReading r = readBag(bag);
  const auto scan = observations::toScan(*observationOf<CObservationPointCloud>(r), {});
  EXPECT_EQ(scan.decoded.scan.size(), 498U);
  EXPECT_EQ(scan.decoded.scan.input_points, 500U);
  EXPECT_THAT(r.entries[0].channels.ring, SizeIs(500)) << "one for each point, also those";
}

TEST(RosBag, ColourWithoutIntensityIsKept)
{
  using msgs::PointField;
  const std::vector<float> one = {1};
  auto cloud = CloudBuilder(1)
                   .column("x", PointField::FLOAT32, one)
                   .column("y", PointField::FLOAT32, one)
                   .column("z", PointField::FLOAT32, one)
                   .column("rgb", PointField::FLOAT32, std::vector<uint32_t>{0xff8000})
                   .build();
  cloud.header = rosHeader(0, "camera");
  BagFile bag;
  bag.write("/points", 0, cloud);
  const BagReading r = readBag(bag);
  const auto& map = dynamic_cast<const mrpt::maps::CColouredPointsMap&>(
      *observationOf<CObservationPointCloud>(r)->pointcloud);
  float x = 0;
  float red = 0;
  float green = 0;
  float blue = 1;
  map.getPointRGB(0, x, x, x, red, green, blue);
  EXPECT_EQ(red, 1);
  EXPECT_NEAR(green, 128 / 255.0, 1e-6);
  EXPECT_EQ(blue, 0);
}

/** Bearing of ray i on the vehicle. */
double bearing(const CObservation2DRangeScan& scan, size_t i)
{
  const double step = scan.aperture / static_cast<double>(scan.getScanSize() - 1);
  const double from_left = scan.aperture / 2.0 - step * static_cast<double>(i);
  return scan.sensorPose.yaw() + (scan.rightToLeft ? -from_left : from_left);
}

TEST(RosBag, RaysOfALaserLookWhereTheyLooked)
{
  BagFile bag;
  bag.writeTf(rosTransform(0, "base_link", "laser", 0.5, 0.25));
  auto lopsided = rosLaser(0, 5);
  lopsided.angle_min = -0.5F;
  auto clockwise = rosLaser(1, 5);
  clockwise.angle_min = 1.0F;
  clockwise.angle_increment = -clockwise.angle_increment;
  bag.write("/scan", 0, lopsided);
  bag.write("/scan", 1, clockwise);
  const BagReading r = readBag(bag);
  const auto first = throughALog(*observationOf<CObservation2DRangeScan>(r, 0));
  const auto second = throughALog(*observationOf<CObservation2DRangeScan>(r, 1));
  // Angles are floats.
  EXPECT_NEAR(bearing(*first, 0), 0.25 - 0.5, 1e-6);
  EXPECT_NEAR(bearing(*first, 180), 0.25 - 0.5 + 2 * kHalfPi, 1e-6);
  EXPECT_TRUE(first->rightToLeft);
  EXPECT_NEAR(bearing(*second, 0), 0.25 + 1, 1e-6);
  EXPECT_NEAR(bearing(*second, 180), 0.25 + 1 - 2 * kHalfPi, 1e-6);
  EXPECT_FALSE(second->rightToLeft);
  EXPECT_EQ(first->sensorPose.x(), 0.5);
}

TEST(RosBag, RaysWithoutAnEchoAndErrorsAreToldApart)
{
  auto laser = rosLaser(0, 5);
  const float inf = std::numeric_limits<float>::infinity();
  laser.ranges[0] = inf;
  laser.ranges[1] = 31;
  laser.ranges[2] = std::numeric_limits<float>::quiet_NaN();
  laser.ranges[3] = -inf;
  laser.ranges[4] = 0.05F;
  BagFile bag;
  bag.write("/scan", 0, laser);
  const auto scan = observationOf<CObservation2DRangeScan>(readBag(bag));
  const auto decoded = observations::toScan(*scan, {}).decoded;
  EXPECT_EQ(decoded.scan.size(), 176U);
  EXPECT_EQ(decoded.rejects.of(points::Reject::no_return), 2U);
  EXPECT_EQ(decoded.rejects.of(points::Reject::flagged), 3U);
  for (size_t i = 0; i < 5; ++i)
  {
    EXPECT_FALSE(scan->getScanRangeValidity(i)) << i;
    EXPECT_TRUE(std::isfinite(scan->getScanRange(i))) << i;
  }
}

TEST(RosBag, OdometryInThePlaneKeepsItsVelocity)
{
  BagFile bag;
  bag.write("/odom", 0, rosOdometry(0, 3, 0));
  const auto odometry = throughALog(*observationOf<CObservationOdometry>(readBag(bag)));
  EXPECT_EQ(odometry->odometry.x(), 3);
  EXPECT_TRUE(odometry->hasVelocities);
  EXPECT_EQ(odometry->velocityLocal.vx, 1.5);
  EXPECT_EQ(odometry->velocityLocal.omega, 0.25);
}

TEST(RosBag, OdometryThatLeavesThePlaneIsARobotPoseFromItsFirstMessageOn)
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

TEST(RosBag, GivesImuAndFixes)
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

TEST(RosBag, StampsOrderTheLogAndZeroOnesAreTheRecordings)
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

TEST(RosBag, UnknownTypesAndFramesAreTold)
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

TEST(RosBag, OnlyTopicsAskedForAndABaseOfChoice)
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

TEST(RosBag, HostileTopicsBecomePlainLabels)
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

TEST(RosBag, ThatIsNoneIsRefusedByName)
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
