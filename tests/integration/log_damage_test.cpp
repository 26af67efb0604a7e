// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/obs/CSensoryFrame.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <support/data.h>
#include <support/log_damage.h>
#include <support/synthetic_logs.h>

namespace
{
using ::testing::HasSubstr;
using traverse::logs::LogEnd;
using traverse::testing::gzipped;
using traverse::testing::laserLog;
using traverse::testing::laserScan;
using traverse::testing::peakMebibytes;
using traverse::testing::readDamaged;
using traverse::testing::serialised;

/** A scan that says it has as many beams as given. */
std::string bomb(const std::string& beams)
{
  std::string bytes = serialised(laserScan(9));
  const size_t at = bytes.find(std::string("\xb5\0\0\0", 4));  // 181
  EXPECT_NE(at, std::string::npos);
  return bytes.replace(at, 4, beams);
}

TEST(LogDamage, OfGzipLogsIsAlwaysTold)
{
  traverse::testing::damageGzip(gzipped(laserLog(20)), 1, 40);
}

TEST(LogDamage, OfPlainLogsNeverCrashes)
{
  traverse::testing::damagePlain(laserLog(5), 2, 20);
}

TEST(LogDamage, WhatCameBeforeACutIsDelivered)
{
  const std::string log = laserLog(10);
  const auto r = readDamaged(log.substr(0, log.size() - 5));
  EXPECT_EQ(r.scans, 9U);
  EXPECT_EQ(r.report.end, LogEnd::damaged);
  EXPECT_THAT(r.report.damage, HasSubstr("cut short"));
  EXPECT_THAT(r.report.damage, HasSubstr("at object 10 (mrpt::obs::CObservation2DRangeScan)"));
  EXPECT_THAT(r.report.damage, HasSubstr("near byte " + std::to_string(log.size() - 5)));
}

TEST(LogDamage, WithinAFrameLosesOnlyWhatFollows)
{
  mrpt::obs::CSensoryFrame frame;
  for (int i = 0; i < 3; ++i)
  {
    frame.insert(std::make_shared<mrpt::obs::CObservation2DRangeScan>(laserScan(i)));
  }
  const std::string log = serialised(frame);
  EXPECT_EQ(readDamaged(log.substr(0, log.size() - 100)).scans, 2U);
}

TEST(LogDamage, ABadCheckSumIsToldAfterAllScansAreDelivered)
{
  std::string packed = gzipped(laserLog(10));
  packed[packed.size() - 6] = static_cast<char>(packed[packed.size() - 6] ^ 4);
  const auto r = readDamaged(packed);
  EXPECT_EQ(r.scans, 10U);
  EXPECT_THAT(r.report.damage, HasSubstr("corrupt"));
}

TEST(LogDamage, GarbageBehindTheLogIsTold)
{
  EXPECT_EQ(readDamaged(gzipped(laserLog(3)) + "garbage").report.end, LogEnd::damaged);
  const auto plain = readDamaged(laserLog(3) + "garbage");
  EXPECT_EQ(plain.scans, 3U);
  EXPECT_EQ(plain.report.end, LogEnd::damaged);
}

TEST(LogDamage, LengthBombsKillTheReaderNotUs)
{
  for (const std::string& beams :
       {std::string("\xff\xff\xff\xff"), std::string("\0\0\xc0\x35", 4),
        std::string("\xff\xff\xff\x0f")})
  {
    const auto r = readDamaged(laserLog(3) + bomb(beams) + laserLog(3));
    EXPECT_EQ(r.scans, 3U);
    EXPECT_EQ(r.report.end, LogEnd::damaged);
    EXPECT_THAT(r.report.damage, HasSubstr("at object 4 "));
  }
  EXPECT_LT(peakMebibytes(), 1000) << "this process does not grow with what a file claims";
}

TEST(LogDamage, AnUnknownClassIsNamed)
{
  std::string log = laserLog(2);
  log += "\x95mrpt::obs::CMadeUpOne";
  log.append(2, '\0');
  const auto r = readDamaged(log);
  EXPECT_EQ(r.scans, 2U);
  EXPECT_THAT(r.report.damage, HasSubstr("unknown class 'mrpt::obs::CMadeUpOne'"));
}

TEST(LogDamage, ANewerVersionOfAClassIsNoCrash)
{
  std::string log = serialised(laserScan(0));
  log[1 + (log[0] & 0x7f)] = 99;
  EXPECT_EQ(readDamaged(laserLog(1) + log).report.end, LogEnd::damaged);
}

TEST(LogDamage, OtherFilesAreNoLogs)
{
  std::mt19937 random(5);
  std::string noise(10'000, '\0');
  for (char& c : noise)
  {
    c = static_cast<char>(random());
  }
  for (const std::string& bytes :
       {noise, std::string(5000, '\0'), std::string("hello, world\n"), gzipped(noise),
        std::string("\x1f\x8b"), std::string("\x89PNG\r\n\x1a\n"),
        std::string("ply\nformat ascii 1.0\n")})
  {
    const auto r = readDamaged(bytes);
    EXPECT_FALSE(r.report.complete());
    EXPECT_EQ(r.scans, 0U);
    EXPECT_THAT(r.report.damage, HasSubstr("damaged.rawlog"));
  }
}

TEST(LogDamage, AMapOfMrptIsNoLog)
{
  const std::string map = traverse::testing::mrptData("2006-MalagaCampus.gridmap.gz");
  TRAVERSE_NEEDS(map);
  const auto r = readDamaged(traverse::testing::readText(map));
  EXPECT_EQ(r.report.end, LogEnd::not_a_log);
  EXPECT_THAT(r.report.damage, HasSubstr("COccupancyGridMap2D"));
}

TEST(LogDamage, MalformedFilesOfOtherKindsAreNoLogs)
{
  const std::filesystem::path folder = traverse::testing::sharedData("malformed");
  TRAVERSE_NEEDS(folder);
  int files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
  {
    // One in eight: the slow tier takes them all.
    if (entry.is_regular_file() && entry.file_size() > 0 && files++ % 8 == 0)
    {
      const auto r = readDamaged(traverse::testing::readText(entry.path()));
      EXPECT_FALSE(r.report.complete()) << entry.path();
    }
  }
  EXPECT_GT(files, 100);
}
}  // namespace
