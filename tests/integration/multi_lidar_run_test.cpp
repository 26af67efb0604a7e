// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// traverse-map with the map of several lidars.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <support/scratch_folder.h>
#include <support/traverse_map.h>

namespace
{
using namespace traverse::testing;
using ::testing::HasSubstr;

const std::string kStreet = "/usr/share/mrpt/datasets/test_velodyne_VLP16.rawlog";

Finished mapStreet(const std::filesystem::path& output, std::vector<std::string> more = {})
{
  std::vector<std::string> arguments = {
      ini("one_lidar"),
      "--rawlog",
      kStreet,
      "--output",
      output.string(),
      "--set",
      "Poses.source=identity",
      "--set",
      "Vehicle.base_height_m=2"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return traverseMap(arguments);
}

TEST(MultiLidarRun, WritesLayersPicturesAndReport)
{
  const ScratchFolder folder;
  const auto out = folder.path() / "out";
  const Finished run = mapStreet(out);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  for (const char* name :
       {"map.traverse", "map.gridmap", "occupancy_state.tif", "sensor_mask.tif",
        "safety_buffer.tif", "occupancy_view.pgm", "occupancy_view.yaml", "report.html"})
  {
    EXPECT_TRUE(std::filesystem::exists(out / name)) << name;
  }
  const auto metrics = metricsOf(out);
  const auto& cells = metrics.at("maps").at(0).at("cells_by_class");
  EXPECT_GT(cells.at("obstacle").get<int>(), 100);
  EXPECT_GT(cells.at("free, seen by one sensor").get<int>(), 1000);
  EXPECT_EQ(cells.at("free, seen by several").get<int>(), 0);
}

TEST(MultiLidarRun, SaysWhyOfACell)
{
  const ScratchFolder folder;
  const auto out = folder.path() / "out";
  ASSERT_EQ(mapStreet(out).exit_code, 0);
  const Finished why = traverseMap({"--why", "3,1", out.string()});
  EXPECT_EQ(why.exit_code, 0) << why.err;
  EXPECT_THAT(why.out, HasSubstr("multi_lidar_grid"));
  EXPECT_THAT(why.out, HasSubstr("safety_buffer: "));
}

TEST(MultiLidarRun, RefusesAMisspeltKeyWithItsLine)
{
  const ScratchFolder folder;
  const Finished run = mapStreet(
      folder.path() / "out",
      {"--set", "Maps_CWrappableMultiLidarGrid_00_insertOpts.clear_after=3"});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_THAT(run.err, HasSubstr("clear_after_sweeps"));
}

TEST(MultiLidarRun, TheSameLogGivesTheSameBytes)
{
  const ScratchFolder folder;
  ASSERT_EQ(mapStreet(folder.path() / "a").exit_code, 0);
  ASSERT_EQ(mapStreet(folder.path() / "b").exit_code, 0);
  for (const char* name : {"map.traverse", "map.gridmap", "occupancy_state.tif"})
  {
    EXPECT_EQ(readText(folder.path() / "a" / name), readText(folder.path() / "b" / name)) << name;
  }
}
}  // namespace
