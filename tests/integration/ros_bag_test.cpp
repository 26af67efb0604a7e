// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/observations/to_scan.h>

#include <mrpt/maps/CColouredPointsMap.h>
#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationVelodyneScan.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <support/mrpt_round_trip.h>
#include <support/ros_bag.h>
#include <support/ros_velodyne.h>
#include <support/simulated_velodyne.h>

namespace
{
using namespace traverse;
using namespace traverse::testing;
using namespace mrpt::obs;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;
using ::testing::SizeIs;

constexpr double kHalfPi = 1.5707963267948966;

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

TEST(RosBag, PacketsOfAVelodyneBeginAtTheirFirstStamp)
{
  const auto wall = [](int, double) {
    return std::array{sensors::VelodyneReturn{5000, 10}, sensors::VelodyneReturn{5000, 10}};
  };
  const Capture capture = SimulatedVelodyne{}.run(5, wall);
  msgs::VelodyneScan scan;
  scan.header = rosHeader(1, "velodyne");
  for (size_t i = 0; i < capture.packets.size(); ++i)
  {
    auto& packet = scan.packets.emplace_back();
    packet.stamp = rosTime(0.9 + 0.02 * static_cast<double>(i));
    std::copy_n(capture.packets[i].begin(), packet.data.size(), packet.data.begin());
  }
  BagFile bag;
  writeLidarTf(bag);
  bag.write("/velodyne_packets", 1, scan);
  const auto got = throughALog(*observationOf<CObservationVelodyneScan>(readBag(bag)));
  EXPECT_NEAR(mrpt::Clock::toDouble(got->timestamp), kBagStart_s + 0.9, 1e-6);
  EXPECT_EQ(got->sensorPose.x(), 2);
  EXPECT_FALSE(got->calibration.empty()) << "stock programs want one";
  EXPECT_EQ(observations::toScan(*got, {}).decoded.scan.size(), capture.rawReturns());
}
}  // namespace
