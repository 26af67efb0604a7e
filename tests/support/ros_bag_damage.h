// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <random>
#include <support/ros_bag.h>
#include <sys/resource.h>

// What damaged bags do to the importer, for the default and the slow tier.
namespace traverse::testing
{
/** A bag of many chunks: 30 clouds and 30 laser scans. */
inline std::string bagBytes(rosbag::CompressionType compression)
{
  BagFile bag(compression, 8192);
  bag.writeTf(rosTransform(0, "base_link", "velodyne", 2, 0));
  for (int i = 0; i < 30; ++i)
  {
    bag.write("/velodyne_points", i, velodyneCloud(i, 100, 10));
    bag.write("/scan", i, rosLaser(i, 5));
  }
  return bag.bytes();
}

/** One of: a few bits flipped, a length overwritten, the end cut off. */
inline std::string mutatedBag(std::string bytes, std::mt19937& random)
{
  const size_t at = random() % (bytes.size() - sizeof(uint32_t));
  if (random() % 4 == 0)
  {
    bytes.resize(at);
    return bytes;
  }
  const uint32_t any = random() % 2 == 0 ? random() : random() >> 24U;
  if (random() % 2 == 0)
  {
    std::memcpy(bytes.data() + at, &any, sizeof(any));
    return bytes;
  }
  for (int i = 0; i < 3; ++i)
  {
    char& c = bytes[random() % bytes.size()];
    c = static_cast<char>(c ^ (1 << random() % 8));
  }
  return bytes;
}

/** Largest resident size of this process so far, MiB. */
inline long peakResident()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024;
}

struct DamagedBags
{
  int complete = 0, partial = 0, refused = 0;
};

/** Reads mutations of a bag with little memory and time: each ends, and gives no more than there
 * was, or is told. */
inline DamagedBags readMutations(rosbag::CompressionType compression, int seed, int mutations)
{
  const std::string good = bagBytes(compression);
  const ScratchFolder dir;
  std::mt19937 random(static_cast<uint32_t>(seed));
  ros_bags::BagParams params;
  params.reader_memory_mb = 256;
  params.reader_timeout_s = 5;
  DamagedBags seen;
  for (int i = 0; i < mutations; ++i)
  {
    SCOPED_TRACE("seed " + std::to_string(seed) + " mutation " + std::to_string(i));
    writeText(dir / "damaged.bag", mutatedBag(good, random));
    try
    {
      const BagReading r = readBag(dir / "damaged.bag", params);
      EXPECT_LE(r.entries.size(), 60U);
      ++(r.report.damage.empty() ? seen.complete : seen.partial);
    }
    catch (const importing::ImportError& e)
    {
      EXPECT_NE(std::string(e.what()).find("damaged.bag: "), std::string::npos) << e.what();
      ++seen.refused;
    }
  }
  return seen;
}
}  // namespace traverse::testing
