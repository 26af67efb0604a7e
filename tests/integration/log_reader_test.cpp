// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CRawlog.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <support/data.h>
#include <support/log_reading.h>

namespace
{
using namespace traverse;
using namespace traverse::logs;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Pair;
using traverse::testing::laserLog;
using traverse::testing::laserScan;
using traverse::testing::LogReading;
using traverse::testing::mrptData;
using traverse::testing::readLog;
using traverse::testing::readLogBytes;
using traverse::testing::serialised;

TEST(LogReader, ReadsConcatenatedGzipMembersToTheEnd)
{
  const std::string one = traverse::testing::gzipped(laserLog(3));
  std::string later;
  for (int i = 3; i < 5; ++i)
  {
    later += serialised(laserScan(0.1 * i));
  }
  const LogReading r = readLogBytes(one + traverse::testing::gzipped(later));
  EXPECT_TRUE(r.report.complete()) << r.report.damage;
  EXPECT_EQ(r.scans.size(), 5U);
}

TEST(LogReader, ReadsAWholeLogThatIsOneObject)
{
  mrpt::obs::CRawlog log;
  for (int i = 0; i < 3; ++i)
  {
    log.insert(std::make_shared<mrpt::obs::CObservation2DRangeScan>(laserScan(0.1 * i)));
  }
  log.setCommentText("made by a test");
  const LogReading r = readLogBytes(serialised(log));
  EXPECT_TRUE(r.report.complete()) << r.report.damage;
  EXPECT_EQ(r.scans.size(), 3U);
}

TEST(LogReader, CountsWhatIsNoRangeMeasurement)
{
  mrpt::obs::CObservationIMU imu;
  imu.timestamp = laserScan(0).timestamp;
  const LogReading r = readLogBytes(serialised(imu) + laserLog(2) + serialised(imu));
  EXPECT_THAT(r.report.ignored, ElementsAre(Pair("CObservationIMU", 2)));
  EXPECT_THAT(r.report.observations, ElementsAre(Pair("CObservation2DRangeScan", 2)));
  EXPECT_EQ(r.report.objects, 4U);
}

TEST(LogReader, TellsWhenEachSensorSpoke)
{
  mrpt::obs::CObservationIMU imu;
  imu.sensorLabel = "im\nu";
  imu.timestamp = laserScan(0.25).timestamp;
  const LogReading r = readLogBytes(
      serialised(laserScan(1.0)) + serialised(imu) + serialised(laserScan(0.5)) +
      serialised(laserScan(0.5)) + serialised(laserScan(2.0)));
  ASSERT_EQ(r.report.sensors.size(), 2U);
  const SensorTimes& laser = r.report.sensors[0];
  EXPECT_EQ(laser.type, "CObservation2DRangeScan");
  EXPECT_EQ(laser.count, 4U);
  EXPECT_EQ(laser.repeated, 1U);
  EXPECT_EQ(laser.backward, 1U);
  ASSERT_EQ(laser.stamps.size(), 4U);  // as they came, the repeated one too
  EXPECT_EQ(laser.stamps[1], laser.stamps[2]);
  EXPECT_EQ(laser.first, laser.stamps[1]);
  EXPECT_EQ(laser.last, laser.stamps[3]);
  EXPECT_FALSE(laser.sensor_pose_changes);
  EXPECT_EQ(r.report.sensors[1].label, "im?u");
  EXPECT_EQ(r.report.sensors[1].count, 1U);
}

TEST(LogReader, CountsRepeatedAndBackwardStampsAndDropsExactRepetitions)
{
  const LogReading r = readLogBytes(
      serialised(laserScan(1.0, 5)) + serialised(laserScan(1.0, 5)) +  // the same once more
      serialised(laserScan(1.0, 6)) +                                  // another of the same stamp
      serialised(laserScan(0.5, 7)) + serialised(laserScan(2.0, 5)));
  EXPECT_TRUE(r.report.complete());
  EXPECT_EQ(r.scans.size(), 4U);
  EXPECT_EQ(r.report.repeated_stamps, 2U);
  EXPECT_EQ(r.report.backward_stamps, 1U);
  EXPECT_THAT(
      r.report.rejected,
      ElementsAre(Pair("CObservation2DRangeScan: it is the scan before once more", 1)));
}

TEST(LogReader, ScansWithoutAStampNeedARobotThatStandsStill)
{
  auto scan = laserScan(0);
  scan.timestamp = INVALID_TIMESTAMP;
  const std::string log = serialised(scan);
  const LogReading without = readLogBytes(log);
  EXPECT_TRUE(without.scans.empty());
  EXPECT_EQ(without.report.bad_stamps, 1U);
  EXPECT_EQ(without.report.rejected.size(), 1U);
  const LogReading with = readLogBytes(log, {}, {.accept_bad_stamps = true});
  ASSERT_EQ(with.scans.size(), 1U);
  EXPECT_EQ(with.scans[0].scan.stamp, 0);
  EXPECT_EQ(with.report.bad_stamps, 1U);
}

TEST(LogReader, CollectsTheRowsOfATiltingScanner)
{
  std::string log;
  for (int i = 0; i < 20; ++i)
  {
    auto scan = laserScan(0.1 * i);
    const double up = 0.1 * (i < 10 ? i : 19 - i);
    scan.sensorPose = mrpt::poses::CPose3D(0, 0, 1, 0, -up, 0);
    log += serialised(scan);
  }
  observations::ObservationParams sensors;
  sensors.tilting_labels = "LASER";
  const LogReading r = readLogBytes(log, sensors);
  ASSERT_EQ(r.scans.size(), 2U) << "one up, one down";
  // At the top two rows have one tilt: the second one still belongs to the way up.
  EXPECT_EQ(r.scans[0].image.rows, 11);
  EXPECT_EQ(r.scans[1].image.rows, 9);
}

TEST(LogReader, ReadsCloudsBesideTheLogAndNothingElse)
{
  const traverse::testing::ScratchFolder dir;
  std::filesystem::create_directory(dir / "some_Images");
  traverse::testing::writeText(dir / "some_Images" / "a.txt", "1 2 3\n4 5 6\n");
  traverse::testing::writeText(dir / "b.txt", "1 2 3\n4 5 6\n");
  std::string log;
  for (const std::string& name :
       {std::string("a.txt"), std::string("../b.txt"), (dir / "b.txt").string(),
        std::string("/dev/zero")})
  {
    mrpt::obs::CObservationPointCloud cloud;
    cloud.timestamp = laserScan(static_cast<double>(log.size())).timestamp;
    cloud.setAsExternalStorage(
        name, mrpt::obs::CObservationPointCloud::ExternalStorageFormat::PlainTextFile);
    log += serialised(cloud);
  }
  traverse::testing::writeText(dir / "some.rawlog", log);
  const LogReading r = readLog(dir / "some.rawlog");
  EXPECT_TRUE(r.report.complete()) << r.report.damage;
  EXPECT_EQ(r.points(), 2U);
  EXPECT_THAT(
      r.report.rejected,
      ElementsAre(Pair("CObservationPointCloud: it names a file outside its image folder", 3)));
}

TEST(LogReader, FilesThatCannotBeOpenedAreErrorsThatSayWhy)
{
  const traverse::testing::ScratchFolder dir;
  traverse::testing::writeText(dir / "empty", "");
  const auto why = [](const std::filesystem::path& file) -> std::string
  {
    try
    {
      LogReader(file, {}, {});
    }
    catch (const LogError& e)
    {
      EXPECT_THAT(e.what(), HasSubstr(file.string()));
      return e.what();
    }
    return "";
  };
  EXPECT_THAT(why(dir / "none"), HasSubstr("No such file"));
  EXPECT_THAT(why(dir.path()), HasSubstr("directory"));
  EXPECT_THAT(why(dir / "empty"), HasSubstr("empty"));
  EXPECT_THAT(why("/dev/zero"), HasSubstr("no plain file"));
}

TEST(LogReader, ParamsThatDoNotGoTogetherAreRefused)
{
  observations::ObservationParams sensors;
  sensors.min_range_m = 10;
  sensors.max_range_m = 5;
  EXPECT_THROW(readLogBytes(laserLog(1), sensors), options::OptionError);
  LogParams params;
  params.reader_memory_mb = 0;
  EXPECT_THROW(LogReader("/dev/null", params, {}), options::OptionError);
}

TEST(LogReader, MayBeLeftInTheMiddleAndMoved)
{
  const traverse::testing::ScratchFolder dir;
  traverse::testing::writeText(dir / "l", laserLog(2000));
  LogReader first(dir / "l", {}, {});
  LogReader second(dir / "l", {}, {});
  EXPECT_TRUE(first.next());
  EXPECT_TRUE(second.next());
  LogReader third = std::move(first);
  EXPECT_TRUE(third.next());
  EXPECT_EQ(third.report().end, LogEnd::reading);
}

TEST(LogReader, StopsOnRequest)
{
  const traverse::testing::ScratchFolder dir;
  traverse::testing::writeText(dir / "l", laserLog(2000));
  std::atomic<bool> stop = false;
  LogReader reader(dir / "l", {}, {}, {.stop = &stop});
  EXPECT_TRUE(reader.next());
  stop = true;
  size_t more = 0;
  while (reader.next())
  {
    ++more;
  }
  EXPECT_LT(more, 1000U) << "what had arrived is delivered, no more is waited for";
  EXPECT_EQ(reader.report().end, LogEnd::stopped);
  EXPECT_FALSE(reader.report().complete());
}
}  // namespace
