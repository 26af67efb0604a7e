// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/bytes.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cloud_columns.h>
#include <known_types.h>
#include <messages.h>
#include <support/ros_messages.h>

namespace
{
using namespace traverse;
using namespace traverse::ros_bags;
using namespace traverse::testing;
using formats::FormatError;
using msgs::PointField;
using ::testing::ElementsAre;
using ::testing::ElementsAreArray;
using ::testing::HasSubstr;
using ::testing::SizeIs;

constexpr int64_t kStart_ns = int64_t{kBagStart_s} * 1'000'000'000;

template <class M>
void expectKnown()
{
  const KnownType* known = knownType(ros::message_traits::DataType<M>::value());
  ASSERT_NE(known, nullptr);
  EXPECT_EQ(known->md5sum, ros::message_traits::MD5Sum<M>::value()) << known->type;
}

TEST(KnownTypes, HaveTheSumsThatRosComputes)
{
  expectKnown<msgs::TFMessage>();
  expectKnown<msgs::CameraInfo>();
  expectKnown<msgs::PointCloud2>();
  expectKnown<msgs::LaserScan>();
  expectKnown<msgs::Image>();
  expectKnown<msgs::Odometry>();
  expectKnown<msgs::Imu>();
  expectKnown<msgs::NavSatFix>();
}

CloudColumns columnsOf(const msgs::PointCloud2& cloud)
{
  const std::string bytes = rosBytes(cloud);
  return readColumns(parsePointCloud(bytes), kStart_ns);
}

/** Two points, with one more column. */
template <class T>
CloudColumns withColumn(const std::string& name, uint8_t type, const std::vector<T>& values)
{
  const std::vector<float> c = {1, 2};
  return columnsOf(CloudBuilder(2)
                       .column("x", PointField::FLOAT32, c)
                       .column("y", PointField::FLOAT32, c)
                       .column("z", PointField::FLOAT32, c)
                       .column(name, type, values)
                       .build());
}

TEST(CloudColumns, OfAVelodyneDriver)
{
  const CloudColumns c = columnsOf(velodyneCloud(0, 64, 10));
  EXPECT_THAT(c.x, SizeIs(64));
  EXPECT_FLOAT_EQ(c.z[3], -0.7F);
  EXPECT_EQ(c.intensity[63], 63);
  EXPECT_EQ(c.channels.ring[17], 1);
  EXPECT_FLOAT_EQ(c.channels.time_s[32], -0.05F);
}

TEST(CloudColumns, InAnyOrderTypeAndEndianness)
{
  const auto cloud = [](bool big)
  {
    return CloudBuilder(2)
        .column("ring", PointField::UINT8, std::vector<uint8_t>{3, 7})
        .column("z", PointField::FLOAT64, std::vector<double>{5, 6})
        .column("intensity", PointField::UINT16, std::vector<uint16_t>{258, 65535})
        .column("x", PointField::INT16, std::vector<int16_t>{-1, 2})
        .column("y", PointField::FLOAT32, std::vector<float>{3, 4})
        .build(3, big);
  };
  for (const bool big : {false, true})
  {
    const CloudColumns c = columnsOf(cloud(big));
    EXPECT_THAT(c.x, ElementsAre(-1, 2)) << big;
    EXPECT_THAT(c.y, ElementsAre(3, 4)) << big;
    EXPECT_THAT(c.z, ElementsAre(5, 6)) << big;
    EXPECT_THAT(c.intensity, ElementsAre(258, 65535)) << big;
    EXPECT_EQ(c.intensity_full, 65535) << big;
    EXPECT_THAT(c.channels.ring, ElementsAre(3, 7)) << big;
  }
}

TEST(CloudColumns, OrganisedRowsMayHaveATail)
{
  auto cloud = velodyneCloud(0, 6, 10);
  std::vector<uint8_t> rows;
  for (size_t row = 0; row < 2; ++row)
  {
    const auto from = cloud.data.begin() + static_cast<std::ptrdiff_t>(row * 3 * cloud.point_step);
    rows.insert(rows.end(), from, from + 3 * cloud.point_step);
    rows.insert(rows.end(), 5, 0xee);
  }
  const CloudColumns plain = columnsOf(cloud);
  cloud.height = 2;
  cloud.width = 3;
  cloud.row_step = 3 * cloud.point_step + 5;
  cloud.data.assign(rows.begin(), rows.end());
  const CloudColumns organised = columnsOf(cloud);
  EXPECT_EQ(organised.x, plain.x);
  EXPECT_EQ(organised.channels.ring, plain.channels.ring);
}

TEST(CloudColumns, TimesInTheUnitsOfDrivers)
{
  using V = std::vector<double>;
  EXPECT_THAT(
      withColumn("t", PointField::UINT32, std::vector<uint32_t>{0, 50'000'000}).channels.time_s,
      ElementsAre(0, 0.05F));
  EXPECT_THAT(
      withColumn("time", PointField::FLOAT32, std::vector<float>{-0.1F, 0}).channels.time_s,
      ElementsAre(-0.1F, 0));
  const double s = kBagStart_s;
  for (const double unit : {1.0, 1e6, 1e9})
  {
    const auto times = withColumn("timestamp", PointField::FLOAT64, V{s * unit, (s + 0.125) * unit})
                           .channels.time_s;
    ASSERT_THAT(times, SizeIs(2)) << unit;
    // A double of seconds since 1970 has steps of 0.24 us; one of ns of 0.26 us.
    EXPECT_NEAR(times[1], 0.125, 1e-6) << unit;
  }
}

TEST(CloudColumns, WhatMakesNoSenseIsLeftOutAndNoted)
{
  const auto far = withColumn("time", PointField::FLOAT32, std::vector<float>{0, 1e5F});
  EXPECT_TRUE(far.channels.time_s.empty());
  EXPECT_THAT(far.notes, ElementsAre(HasSubstr("'time'")));
  const auto ring = withColumn("ring", PointField::INT32, std::vector<int32_t>{0, -1});
  EXPECT_TRUE(ring.channels.ring.empty());
  EXPECT_THAT(ring.notes, ElementsAre(HasSubstr("'ring'")));
}

TEST(CloudColumns, ColourPackedOrInParts)
{
  EXPECT_THAT(
      withColumn("rgb", PointField::FLOAT32, std::vector<uint32_t>{0xff010203, 0x00ffffff}).rgb,
      ElementsAre(0x010203U, 0xffffffU));
  const std::vector<float> c = {1};
  const auto parts = columnsOf(CloudBuilder(1)
                                   .column("x", PointField::FLOAT32, c)
                                   .column("y", PointField::FLOAT32, c)
                                   .column("z", PointField::FLOAT32, c)
                                   .column("b", PointField::UINT8, std::vector<uint8_t>{3})
                                   .column("g", PointField::UINT8, std::vector<uint8_t>{2})
                                   .column("r", PointField::UINT8, std::vector<uint8_t>{1})
                                   .build());
  EXPECT_THAT(parts.rgb, ElementsAre(0x010203U));
}

TEST(PointCloud, ThatLiesAboutItsSizeIsRefused)
{
  const auto good = velodyneCloud(0, 8, 10);
  const auto refused = [&](const auto& change)
  {
    msgs::PointCloud2 bad = good;
    change(bad);
    EXPECT_THROW(parsePointCloud(rosBytes(bad)), FormatError);
  };
  EXPECT_NO_THROW(parsePointCloud(rosBytes(good)));
  refused([](auto& c) { c.data.pop_back(); });
  refused([](auto& c) { ++c.width; });
  refused([](auto& c) { c.height = 2; });
  refused([](auto& c) { c.height = c.width = 0xffffffff; });
  refused([](auto& c) { c.fields[0].offset = c.point_step - 3; });
  refused([](auto& c) { c.fields[0].offset = 0xfffffffe; });
  refused([](auto& c) { c.fields[0].datatype = 9; });
  refused([](auto& c) { c.point_step = 0; });
  refused(
      [](auto& c)
      {
        c.height = 2;
        c.width = 4;
        c.row_step = c.point_step;
      });
}

TEST(PointCloud, WithoutCoordinatesIsRefusedAndOneWithoutPointsIsNot)
{
  const auto flat = CloudBuilder(1).column("x", PointField::FLOAT32, std::vector<float>{1}).build();
  EXPECT_THROW(columnsOf(flat), FormatError);
  EXPECT_THAT(columnsOf(velodyneCloud(0, 0, 1)).x, SizeIs(0));
  auto rows = velodyneCloud(0, 0, 1);
  rows.height = 0xffffffff;
  EXPECT_EQ(parsePointCloud(rosBytes(rows)).height, 0U) << "nor are its empty rows walked";
}

TEST(Messages, AreReadAsRosWritesThem)
{
  auto laser = rosLaser(1.5, 7);
  laser.intensities = {1, 2};
  const LaserScan scan = parseLaserScan(rosBytes(laser));
  EXPECT_EQ(scan.header.stamp_ns, kStart_ns + 1'500'000'000);
  EXPECT_EQ(scan.header.frame, "laser");
  EXPECT_THAT(scan.ranges_m, ElementsAreArray(laser.ranges));
  EXPECT_THAT(scan.intensities, ElementsAre(1, 2));
  EXPECT_EQ(scan.range_max_m, 30.0F);

  const Odometry odometry = parseOdometry(rosBytes(rosOdometry(0, 2, 3)));
  EXPECT_EQ(odometry.child_frame, "base_link");
  EXPECT_EQ(odometry.T_odom_child.translation(), Eigen::Vector3d(2, 0, 3));
  EXPECT_EQ(odometry.covariance[35], 35);
  EXPECT_EQ(odometry.velocity_m_s.x(), 1.5);

  auto camera = rosCamera("cam");
  camera.binning_x = 2;
  camera.roi.x_offset = 4;
  const CameraInfo info = parseCameraInfo(rosBytes(camera));
  EXPECT_EQ(info.k[4], 31);
  EXPECT_EQ(info.p[6], 11);
  EXPECT_THAT(info.distortion, ElementsAreArray(camera.D));
  EXPECT_EQ(info.binning_x, 2U);
  EXPECT_EQ(info.roi_x, 4U);

  msgs::Imu ros_imu;
  ros_imu.orientation_covariance[0] = -1;
  ros_imu.linear_acceleration.z = 9.8;
  const Imu imu = parseImu(rosBytes(ros_imu));
  EXPECT_FALSE(imu.has_orientation);
  EXPECT_EQ(imu.acceleration_m_s2.z(), 9.8);

  msgs::NavSatFix ros_fix;
  ros_fix.status.status = -1;
  ros_fix.latitude = 36.7;
  const NavSatFix fix = parseNavSatFix(rosBytes(ros_fix));
  EXPECT_EQ(fix.status, -1);
  EXPECT_EQ(fix.latitude_deg, 36.7);
}

TEST(Messages, BrokenTransformsDoNotTakeOthersWithThem)
{
  msgs::TFMessage message;
  message.transforms = {rosTransform(0, "/a", "/b", 1, 0), rosTransform(0, "a", "c", 1, 0)};
  message.transforms[1].transform.rotation.w = 0;
  const auto all = parseTransforms(rosBytes(message));
  ASSERT_THAT(all, SizeIs(1));
  EXPECT_EQ(all[0].child, "b");
  EXPECT_EQ(all[0].header.frame, "a");
}

}  // namespace
