// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/bytes.h>

#include <gtest/gtest.h>

#include <cloud_columns.h>
#include <messages.h>
#include <random>
#include <support/ros_messages.h>
#include <support/ros_velodyne.h>

namespace
{
using namespace traverse::ros_bags;
using namespace traverse::testing;
using traverse::formats::FormatError;

constexpr int64_t kStart_ns = int64_t{kBagStart_s} * 1'000'000'000;

/** Flips bits, sets lengths, cuts. */
std::string mutatedMessage(std::string bytes, std::mt19937& random)
{
  for (uint32_t i = 0; i < 1 + random() % 4; ++i)
  {
    const size_t at = random() % bytes.size();
    if (random() % 4 == 0 && at + 4 <= bytes.size())
    {
      const uint32_t length = random() >> random() % 32;
      std::memcpy(bytes.data() + at, &length, sizeof(length));
    }
    else if (random() % 8 == 0)
    {
      bytes.resize(at + 1);
    }
    else
    {
      bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
    }
  }
  return bytes;
}

template <class Parse>
int refusals(const std::string& good, const Parse& parse, int seed)
{
  std::mt19937 random(static_cast<uint32_t>(seed));
  int refused = 0;
  for (int i = 0; i < 2000; ++i)
  {
    try
    {
      parse(mutatedMessage(good, random));
    }
    catch (const FormatError&)
    {
      ++refused;
    }
  }
  return refused;
}

TEST(Messages, OfAnyBytesAreReadOrRefused)
{
  msgs::TFMessage tf;
  tf.transforms = {rosTransform(0, "a", "b", 1, 0), rosTransform(0, "a", "c", 1, 0)};
  EXPECT_GT(
      refusals(
          rosBytes(velodyneCloud(0, 8, 10)),
          [](const std::string& b) { readColumns(parsePointCloud(b), kStart_ns); }, 1),
      100);
  EXPECT_GT(refusals(rosBytes(rosLaser(0, 1)), parseLaserScan, 2), 100);
  EXPECT_GT(refusals(rosBytes(rosCamera("c")), parseCameraInfo, 3), 100);
  EXPECT_GT(refusals(rosBytes(rosOdometry(0, 1, 1)), parseOdometry, 4), 100);
  EXPECT_GT(refusals(rosBytes(tf), parseTransforms, 5), 100);
  EXPECT_GT(refusals(rosBytes(msgs::Imu()), parseImu, 6), 100);
  EXPECT_GT(refusals(rosBytes(msgs::NavSatFix()), parseNavSatFix, 7), 100);
  EXPECT_GT(refusals(rosBytes(rosImage(0, "c", "rgb8", "abc")), parseImage, 8), 50);
  msgs::VelodyneScan velodyne;
  velodyne.packets.resize(1);
  EXPECT_GT(refusals(rosBytes(velodyne), parseVelodynePackets, 9), 50);
}
}  // namespace
