// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <support/data.h>
#include <support/log_reading.h>

// The logs that Debian's mrpt-common ships.
namespace
{
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Pair;
using traverse::testing::LogReading;
using traverse::testing::mrptData;
using traverse::testing::readLog;

TEST(DebianLogs, TheVlp16ScanGivesEveryValidReturn)
{
  const std::string log = mrptData("test_velodyne_VLP16.rawlog");
  TRAVERSE_NEEDS(log);
  const LogReading r = readLog(log);
  EXPECT_TRUE(r.report.complete()) << r.report.damage;
  EXPECT_EQ(r.points(), 22'591U);
  EXPECT_EQ(r.scans.at(0).image.rows, 16);
  EXPECT_EQ(r.report.bytes_read, r.report.file_size);
}

TEST(DebianLogs, TheRgbdFrameGivesEveryValidPixelInColour)
{
  const std::string log = mrptData("tests_rgbd.rawlog");
  TRAVERSE_NEEDS(log);
  const LogReading r = readLog(log);
  EXPECT_TRUE(r.report.complete()) << r.report.damage;
  EXPECT_EQ(r.points(), 273'225U);
  EXPECT_EQ(r.scans.at(0).scan.rgb.size(), 273'225U);
}

TEST(DebianLogs, ActionAndFramePairsGiveTheScansOfTheirFrames)
{
  const std::string log = mrptData("2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog");
  TRAVERSE_NEEDS(log);
  const LogReading r = readLog(log);
  EXPECT_TRUE(r.report.complete()) << r.report.damage;
  EXPECT_EQ(r.scans.size(), 225U);
  EXPECT_EQ(r.report.objects, 449U);
  EXPECT_EQ(r.scans.at(0).image.columns, 361);
}

TEST(DebianLogs, APlainOneIsReadToo)
{
  const std::string log = mrptData("RO-SLAM_demo.rawlog");
  TRAVERSE_NEEDS(log);
  const LogReading r = readLog(log);
  EXPECT_TRUE(r.report.complete()) << r.report.damage;
  EXPECT_THAT(r.report.ignored, ElementsAre(Pair("CObservationBeaconRanges", 100)));
}

TEST(DebianLogs, ARotatingScanOfSeveralRowsIsRejectedWithAReason)
{
  const std::string log = mrptData("rot_scan_velodyne.rawlog");
  TRAVERSE_NEEDS(log);
  const LogReading r = readLog(log);
  EXPECT_TRUE(r.scans.empty());
  ASSERT_EQ(r.report.rejected.size(), 1U);
  EXPECT_THAT(r.report.rejected.begin()->first, HasSubstr("rotating_elevations_deg"));
  EXPECT_EQ(readLog(mrptData("rot_scan_2d.rawlog")).points(), 359U);
}

TEST(DebianLogs, ARotatingScanWithElevationsIsAScan)
{
  const std::string log = mrptData("rot_scan_velodyne.rawlog");
  TRAVERSE_NEEDS(log);
  traverse::observations::ObservationParams sensors;
  for (int row = 0; row < 16; ++row)
  {
    sensors.rotating_elevations_deg.push_back(-15 + 2 * row);
  }
  const LogReading r = readLog(log, sensors);
  // MRPT made this range image of half the returns (see the VLP-16 scan above).
  EXPECT_EQ(r.points(), 11'305U);
}

TEST(DebianLogs, AllAreComplete)
{
  const std::filesystem::path folder = TRAVERSE_MRPT_DATA_DIR;
  TRAVERSE_NEEDS(folder);
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    // The RGB-D frame has its own test, and takes long in a build without optimisation.
    if (entry.path().extension() == ".rawlog" && entry.path().filename() != "tests_rgbd.rawlog")
    {
      const LogReading r = readLog(entry.path());
      EXPECT_TRUE(r.report.complete()) << r.report.damage;
      EXPECT_EQ(r.report.damage, "");
      EXPECT_GT(r.report.objects, 0U);
    }
  }
}
}  // namespace
