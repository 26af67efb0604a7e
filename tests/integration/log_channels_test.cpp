// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// Rings and times of points come from the file beside a log, through the child that reads it.
#include <traverse/formats/point_channels.h>

#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include <gtest/gtest.h>

#include <limits>
#include <support/log_reading.h>

namespace
{
using namespace traverse;
using namespace traverse::testing;

/** Four points, the second of them none; elevations fall from ring 0 to ring 1. */
mrpt::obs::CObservationPointCloud cloud(double t_s)
{
  auto points = mrpt::maps::CPointsMapXYZI::Create();
  const float none = std::numeric_limits<float>::quiet_NaN();
  points->insertPointRGB(5, 0, 1, 0.5F, 0.5F, 0.5F);
  points->insertPointRGB(none, none, none, 0, 0, 0);
  points->insertPointRGB(5, 1, -1, 0.5F, 0.5F, 0.5F);
  points->insertPointRGB(5, 2, static_cast<float>(1 + t_s), 0.5F, 0.5F, 0.5F);
  mrpt::obs::CObservationPointCloud observation;
  observation.sensorLabel = "TOP";
  observation.timestamp =
      observations::toTimePoint(kLogStart + static_cast<poses::TimeNs>(t_s * 1e9));
  observation.pointcloud = points;
  return observation;
}

formats::CloudKey keyOf(const mrpt::obs::CObservationPointCloud& observation)
{
  const auto& x = observation.pointcloud->getPointsBufferRef_x();
  const auto& y = observation.pointcloud->getPointsBufferRef_y();
  const auto& z = observation.pointcloud->getPointsBufferRef_z();
  return {
      observation.sensorLabel, *observations::toTime(observation.timestamp),
      static_cast<uint32_t>(x.size()),
      formats::cloudChecksum({x.data(), x.size()}, {y.data(), y.size()}, {z.data(), z.size()})};
}

class LogChannels : public ::testing::Test
{
 protected:
  LogChannels()
  {
    writeText(log_, serialised(cloud(0)) + serialised(cloud(0.1)));
    formats::ChannelsWriter writer(log_);
    for (const double t_s : {0.0, 0.1})
    {
      const auto observation = cloud(t_s);
      writer.add(keyOf(observation), {{0, 9, 1, 0}, {0.0F, 0.01F, 0.02F, 0.03F}});
    }
    writer.finish();
    writer.commit();
  }

  ScratchFolder scratch_;
  std::filesystem::path log_ = scratch_ / "a.rawlog";
  std::filesystem::path side_ = formats::channelsFileOf(log_);
};

TEST_F(LogChannels, ReachThePointsThatWereKept)
{
  const LogReading reading = readLog(log_);
  ASSERT_EQ(reading.scans.size(), 2U);
  EXPECT_EQ(reading.report.channels.at("attached"), 2U);
  EXPECT_EQ(reading.report.channels_damage, "");
  const points::ScanBuffer& scan = reading.scans[1].scan;
  EXPECT_EQ(scan.time_s, (std::vector<float>{0.0F, 0.02F, 0.03F}));
  EXPECT_EQ(scan.ring, (std::vector<uint16_t>{1, 0, 1})) << "0 is the lowest";
}

TEST_F(LogChannels, ALogWithoutThemIsAsBefore)
{
  std::filesystem::remove(side_);
  const LogReading reading = readLog(log_);
  EXPECT_EQ(reading.scans.size(), 2U);
  EXPECT_TRUE(reading.scans[0].scan.time_s.empty());
  EXPECT_TRUE(reading.report.channels.empty());
  EXPECT_EQ(reading.report.channels_damage, "");
}

TEST_F(LogChannels, ACutFileIsToldAndGivesWhatItHas)
{
  const std::string good = readText(side_);
  writeText(side_, good.substr(0, good.size() - 40));
  const LogReading reading = readLog(log_);
  ASSERT_EQ(reading.scans.size(), 2U);
  EXPECT_TRUE(reading.report.complete()) << "the log itself is whole";
  EXPECT_NE(reading.report.channels_damage.find("a.rawlog.channels is damaged"), std::string::npos)
      << reading.report.channels_damage;
  EXPECT_EQ(reading.scans[0].scan.time_s.size(), 3U);
  EXPECT_TRUE(reading.scans[1].scan.time_s.empty());
}

TEST_F(LogChannels, ADamagedRecordIsToldAndItsCloudDelivered)
{
  std::string bytes = readText(side_);
  bytes[bytes.size() - 22] ^= 1;  // a time of the last cloud
  writeText(side_, bytes);
  const LogReading reading = readLog(log_);
  EXPECT_EQ(reading.report.channels.at("the side file's are damaged"), 1U);
  EXPECT_EQ(reading.scans.at(1).scan.size(), 3U);
  EXPECT_TRUE(reading.scans.at(1).scan.time_s.empty());
}

TEST_F(LogChannels, AnEditedLogDoesNotGetTheOldOnes)
{
  auto edited = cloud(0);
  edited.pointcloud->setPoint(0, 5, 0, 1.01F);
  writeText(log_, serialised(edited) + serialised(cloud(7)));
  const LogReading reading = readLog(log_);
  EXPECT_EQ(reading.report.channels.at("the side file's are of another cloud"), 1U);
  EXPECT_EQ(reading.report.channels.at("the side file has none for the cloud"), 1U);
  EXPECT_TRUE(reading.scans.at(0).scan.time_s.empty());
}

TEST_F(LogChannels, AFolderInTheirPlaceIsTold)
{
  std::filesystem::remove(side_);
  std::filesystem::create_directory(side_);
  const LogReading reading = readLog(log_);
  EXPECT_EQ(reading.scans.size(), 2U);
  EXPECT_FALSE(reading.report.channels_damage.empty());
}
}  // namespace
