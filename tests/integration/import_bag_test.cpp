// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// A ROS 1 bag through traverse-import, to a log with rings and times that our reader and stock
// programs read.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <support/log_reading.h>
#include <support/ros_bag.h>
#include <support/ros_velodyne.h>
#include <support/traverse_import.h>

namespace
{
using namespace traverse::testing;
using ::testing::HasSubstr;

class ImportBag : public ::testing::Test
{
 protected:
  void SetUp() override
  {
    bag_.writeTf(rosTransform(0, "base_link", "velodyne", 2, 0));
    for (int i = 0; i < 5; ++i)
    {
      bag_.write("/velodyne_points", 1.05 + 0.1 * i, velodyneCloud(1 + 0.1 * i, 500, 10));
    }
    bag_.bytes();  // closes it
  }

  BagFile bag_;
  ScratchFolder scratch_;
  std::filesystem::path log_ = scratch_ / "made.rawlog";
};

TEST_F(ImportBag, IsRecognisedAndKeepsWhatStockProgramsLose)
{
  const Finished ran = traverseImport(bag_.path(), log_, {});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_THAT(ran.err, HasSubstr("ros-bag"));
  const LogReading reading = readLog(log_);
  ASSERT_EQ(reading.scans.size(), 5U);
  EXPECT_EQ(reading.scans[0].scan.ring.size(), reading.scans[0].scan.size());
  EXPECT_EQ(reading.scans[0].scan.time_s.size(), reading.scans[0].scan.size());
  EXPECT_EQ(reading.scans[0].scan.T_base_sensor.translation().x(), 2);
  EXPECT_THAT(stockInfo(log_), HasSubstr("velodyne_points"));
}

TEST_F(ImportBag, GivesTheTimesAskedFor)
{
  const Finished ran = traverseImport(bag_.path(), log_, {"--from", "0.15", "--to", "0.35"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(readLog(log_).scans.size(), 2U);
}

TEST_F(ImportBag, RefusesOptionsOfOneSensor)
{
  const Finished ran = traverseImport(bag_.path(), log_, {"--rate-hz", "10"});
  EXPECT_EQ(ran.exit_code, 4);
  EXPECT_THAT(ran.err, HasSubstr("--rate-hz"));
  EXPECT_FALSE(std::filesystem::exists(log_));
}
}  // namespace
