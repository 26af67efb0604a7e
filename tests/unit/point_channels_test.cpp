// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/point_channels.h>
#include <traverse/formats/safe_file.h>

#include <gtest/gtest.h>

#include <fcntl.h>
#include <limits>
#include <support/scratch_folder.h>
#include <unistd.h>

namespace
{
using namespace traverse::formats;
using namespace traverse::testing;
using Found = ChannelsReader::Found;

const CloudKey kFirst = {"top", 1'600'000'000'123'456'700, 3, 0xAA};
const CloudKey kSecond = {"top", 1'600'000'000'223'456'700, 2, 0xBB};
const PointChannels kBoth = {{0, 7, 65535}, {-0.5F, 0.0F, 0.1F}};
const PointChannels kTimes = {{}, {0.25F, 0.5F}};

class PointChannelsFile : public ::testing::Test
{
 protected:
  PointChannelsFile()
  {
    ChannelsWriter writer(log_);
    writer.add(kFirst, kBoth);
    writer.add(kSecond, kTimes);
    writer.finish();
    writer.commit();
    good_ = readText(channelsFileOf(log_));
  }

  /** A reader of these bytes, and what it says of the two clouds. */
  struct Reading
  {
    std::string damage;
    size_t clouds = 0;
    ChannelsReader::Answer first, second;
  };

  Reading read(const std::string& bytes) const
  {
    writeText(scratch_ / "read", bytes);
    const int fd = ::open((scratch_ / "read").c_str(), O_RDONLY);
    const ChannelsReader reader(fd);
    Reading reading = {reader.damage(), reader.clouds(), reader.find(kFirst), reader.find(kSecond)};
    ::close(fd);
    return reading;
  }

  ScratchFolder scratch_;
  std::filesystem::path log_ = scratch_ / "a.rawlog";
  std::string good_;
};

TEST_F(PointChannelsFile, GivesBackWhatWasWritten)
{
  const Reading reading = read(good_);
  EXPECT_EQ(reading.damage, "");
  EXPECT_EQ(reading.clouds, 2U);
  EXPECT_EQ(reading.first.found, Found::yes);
  EXPECT_EQ(reading.first.channels, kBoth);
  EXPECT_EQ(reading.second.channels, kTimes);
  EXPECT_FALSE(std::filesystem::exists(channelsFileOf(log_).string() + ".partial"));
}

TEST_F(PointChannelsFile, StampsAreComparedToTheResolutionOfALog)
{
  const int fd = ::open(channelsFileOf(log_).c_str(), O_RDONLY);
  const ChannelsReader reader(fd);
  CloudKey key = kFirst;
  key.stamp_ns += 99;
  EXPECT_EQ(reader.find(key).found, Found::yes);
  key.stamp_ns += 1;
  EXPECT_EQ(reader.find(key).found, Found::none);
  key = kFirst;
  key.sensor_label = "left";
  EXPECT_EQ(reader.find(key).found, Found::none);
  ::close(fd);
}

TEST_F(PointChannelsFile, ACloudThatWasChangedGetsNone)
{
  const int fd = ::open(channelsFileOf(log_).c_str(), O_RDONLY);
  const ChannelsReader reader(fd);
  CloudKey key = kFirst;
  key.checksum ^= 1;
  EXPECT_EQ(reader.find(key).found, Found::another);
  key = kFirst;
  key.points = 4;
  EXPECT_EQ(reader.find(key).found, Found::another);
  ::close(fd);
}

TEST_F(PointChannelsFile, EveryFlippedBitIsNoticed)
{
  for (size_t bit = 0; bit < good_.size() * 8; bit += 5)
  {
    std::string bytes = good_;
    bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1U << (bit % 8)));
    const Reading reading = read(bytes);
    const bool noticed = !reading.damage.empty() || reading.first.found == Found::damaged ||
                         reading.second.found == Found::damaged;
    ASSERT_TRUE(noticed) << "bit " << bit;
    ASSERT_TRUE(reading.first.found != Found::yes || reading.first.channels == kBoth) << bit;
    ASSERT_TRUE(reading.second.found != Found::yes || reading.second.channels == kTimes) << bit;
  }
}

TEST_F(PointChannelsFile, WhatStandsBeforeACutIsRead)
{
  for (size_t size = 0; size < good_.size(); ++size)
  {
    const Reading reading = read(good_.substr(0, size));
    ASSERT_FALSE(reading.damage.empty()) << size;
    ASSERT_TRUE(reading.first.found != Found::yes || reading.first.channels == kBoth) << size;
  }
  EXPECT_EQ(read(good_.substr(0, good_.size() - 20)).first.found, Found::yes);
  EXPECT_FALSE(read(good_ + "x").damage.empty());
}

TEST_F(PointChannelsFile, TimesThatAreNoneAreDamage)
{
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), 3601.0F})
  {
    ChannelsWriter writer(log_);
    writer.add(kSecond, {{}, {bad, 0}});
    writer.finish();
    writer.commit();
    EXPECT_EQ(read(readText(channelsFileOf(log_))).second.found, Found::damaged);
  }
}

TEST_F(PointChannelsFile, AWriterThatIsNotCommittedLeavesTheOldFile)
{
  {
    ChannelsWriter writer(log_);
    writer.add(kSecond, kTimes);
    writer.finish();
    EXPECT_THROW(ChannelsWriter another(log_), FileError) << "two writers of one file";
  }
  EXPECT_EQ(readText(channelsFileOf(log_)), good_);
  EXPECT_FALSE(std::filesystem::exists(channelsFileOf(log_).string() + ".partial"));
}

TEST_F(PointChannelsFile, ChannelsOfAnotherLengthAreRefused)
{
  ChannelsWriter writer(log_);
  EXPECT_THROW(writer.add(kFirst, kTimes), std::invalid_argument);
  writer.add(kFirst, {});
  EXPECT_EQ(writer.clouds(), 0U);
}
}  // namespace
