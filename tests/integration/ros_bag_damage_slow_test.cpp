// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/maps/CPointsMap.h>
#include <mrpt/maps/registerAllClasses.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/serialization/CArchive.h>

#include <gtest/gtest.h>

#include <support/command.h>
#include <support/ros_bag_damage.h>

namespace
{
using namespace traverse::testing;

TEST(RosBagDamageSlow, HundredsOfMutations)
{
  using namespace rosbag::compression;
  DamagedBags all;
  for (int seed = 10; seed < 13; ++seed)
  {
    for (const auto compression : {Uncompressed, BZ2, LZ4})
    {
      const DamagedBags some = readMutations(compression, seed, 60);
      all.complete += some.complete;
      all.partial += some.partial;
      all.refused += some.refused;
    }
  }
  std::printf(
      "complete %d, partial %d, refused %d, peak %ld MiB\n", all.complete, all.partial, all.refused,
      peakResident());
  EXPECT_EQ(all.complete + all.partial + all.refused, 540);
#ifndef TRAVERSE_SANITIZED
  EXPECT_LT(peakResident(), 400);
#endif
}

/** Points of each cloud of a rawlog. */
std::vector<size_t> cloudSizes(const std::filesystem::path& log)
{
  mrpt::maps::registerAllClasses_mrpt_maps();
  mrpt::io::CFileGZInputStream file(log.string());
  auto archive = mrpt::serialization::archiveFrom(file);
  std::vector<size_t> sizes;
  try
  {
    for (;;)
    {
      const auto object = archive.ReadObject();
      if (const auto c = std::dynamic_pointer_cast<mrpt::obs::CObservationPointCloud>(object))
      {
        sizes.push_back(c->pointcloud->size());
      }
    }
  }
  catch (const std::exception&)
  {
    return sizes;  // MRPT's way to say that it is over
  }
}

TEST(RosBagStock, GivesCloudsOfTheSameSizeAsRosbag2rawlog)
{
  BagFile bag;
  bag.writeTf(rosTransform(0, "world", "base_link", 0, 0));
  bag.writeTf(rosTransform(0, "base_link", "velodyne", 2, 0));
  for (int i = 1; i < 4; ++i)
  {
    bag.write("/velodyne_points", i, velodyneCloud(i, 400 + 50 * static_cast<size_t>(i), 10));
  }
  const BagReading ours = readBag(bag);
  const ScratchFolder dir;
  writeText(
      dir / "c.yml",
      "sensors:\n  velodyne:\n    type: 'CObservationPointCloud'\n    topic: '/velodyne_points'\n");
  const std::string said = outputOf(
      "rosbag2rawlog -f world -c " + (dir / "c.yml").string() + " -o " +
      (dir / "stock.rawlog").string() + " " + bag.path().string());
  const std::vector<size_t> stock = cloudSizes(dir / "stock.rawlog");
  ASSERT_EQ(stock.size(), 3U) << said;
  for (size_t i = 0; i < stock.size(); ++i)
  {
    EXPECT_EQ(
        observationOf<mrpt::obs::CObservationPointCloud>(ours, i)->pointcloud->size(), stock[i]);
  }
}
}  // namespace
