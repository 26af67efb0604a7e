// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// The same bytes for any number of threads, and for a log mapped in pieces and merged.
#include "support/map_pieces.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace
{
using namespace traverse::testing;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

TEST_F(TraverseMapPieces, ThreadsDoNotMatter)
{
  writeText(scratch_ / "bend.rawlog", drivenVelodyneLog({0.1, 0.5, 0.9, 1.3, 1.7, 2.1}));
  const std::string two_maps =
      "[traverse-map]\nscene = false\npictures = false\n[Poses]\nsource = robot_pose\n[Maps]\n"
      "CTraversabilityGridMap_count = 2\n" +
      kInsert + "extent = rolling\nwindow_m = 40\n[Maps_CTraversabilityGridMap_01_insertOpts]\n" +
      "extent = growing\ncell_size_m = 0.3\n";
  for (const char* threads : {"1", "2", "3", "8"})
  {
    const std::string folder = std::string("threads") + threads;
    const Finished ran =
        map(folder, scratch_ / "bend.rawlog", two_maps,
            {"--set", std::string("traverse-map.threads=") + threads});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_EQ(metricsOf(scratch_ / folder)["deskew"]["corrected"], 6);
    EXPECT_EQ(archive(folder), archive("threads1"));
    EXPECT_EQ(
        readText(scratch_ / folder / "map_01.traverse"),
        readText(scratch_ / "threads1" / "map_01.traverse"));
  }
}

TEST_F(TraverseMapPieces, MaxScansDoesNotDependOnThreads)
{
  for (const char* threads : {"1", "2"})
  {
    const Finished ran =
        map(threads, mrptData(kLaserLog), laserIni(),
            {"--set", std::string("traverse-map.threads=") + threads, "--set",
             "traverse-map.max_scans=17"});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
  }
  EXPECT_EQ(metricsOf(scratch_ / "2")["scans"], 17);
  EXPECT_EQ(metricsOf(scratch_ / "2")["observations"], metricsOf(scratch_ / "1")["observations"]);
  EXPECT_EQ(archive("2"), archive("1"));
}

TEST_F(TraverseMapPieces, MergedAreTheWholeLog)
{
  for (const char* options : {"extent = growing\n", "extent = fixed\nfixed_max_x_m = 6\n"})
  {
    const std::string ini_text = iniOf("odometry", options);
    ASSERT_EQ(map("whole", mrptData(kLaserLog), ini_text, {"--force"}).exit_code, 0);
    for (const int k : {1, 2, 3})
    {
      const std::string piece = std::to_string(k) + "/3";
      ASSERT_EQ(
          map(std::to_string(k), mrptData(kLaserLog), ini_text, {"--force", "--piece", piece})
              .exit_code,
          0);
    }
    std::error_code none;
    fs::remove_all(scratch_ / "merged", none);
    const Finished merged = merge({"3", "1", "2"}, "merged");
    ASSERT_EQ(merged.exit_code, 0) << merged.err;
    EXPECT_EQ(merged.out, (scratch_ / "merged").string() + "/report.html\n");
    EXPECT_EQ(archive("merged"), archive("whole"));
    EXPECT_EQ(
        readText(scratch_ / "merged" / "traversability_class.tif"),
        readText(scratch_ / "whole" / "traversability_class.tif"));
  }
}

TEST_F(TraverseMapPieces, OctreesOfPiecesMergeToo)
{
  const std::string ini_text = iniOf("odometry", "extent = growing\n") +
                               "[Maps_CTraversabilityGridMap_00_octomapOpts]\nresolution_m = 0.1\n";
  ASSERT_EQ(map("whole", mrptData(kLaserLog), ini_text).exit_code, 0);
  for (const char* k : {"1", "2"})
  {
    const std::string piece = std::string(k) + "/2";
    ASSERT_EQ(map(k, mrptData(kLaserLog), ini_text, {"--piece", piece}).exit_code, 0);
  }
  const Finished merged = merge({"1", "2"}, "merged");
  ASSERT_EQ(merged.exit_code, 0) << merged.err;
  for (const char* file : {"map.bt", "map.ot"})
  {
    EXPECT_GT(readText(scratch_ / "whole" / file).size(), 1000U);
    EXPECT_EQ(readText(scratch_ / "merged" / file), readText(scratch_ / "whole" / file)) << file;
  }
}

TEST_F(TraverseMapPieces, MetricsAddUpToThoseOfTheWholeLog)
{
  ASSERT_EQ(map("whole", mrptData(kLaserLog), laserIni()).exit_code, 0);
  mapTwoPieces();
  ASSERT_EQ(merge({"1", "2"}, "merged").exit_code, 0);
  EXPECT_EQ(metricsOf(scratch_ / "2")["piece"]["number"], 2);
  EXPECT_EQ(metricsOf(scratch_ / "2")["piece"]["of"], 2);
  auto whole = metricsOf(scratch_ / "whole");
  const auto merged = metricsOf(scratch_ / "merged");
  EXPECT_EQ(merged["merged_pieces"], 2);
  auto& files = whole["files"];
  files.erase(
      std::remove(files.begin(), files.end(), "trajectory.tum"), files.end());  // of one log
  for (const auto& [key, value] : whole.items())
  {
    if (key.rfind("seconds", 0) != 0 && key != "points_per_second" && key != "peak_memory_mb")
    {
      EXPECT_EQ(merged[key], value) << key;
    }
  }
}

/** Deskewing needs poses beyond a piece's borders, and stamps go back across them. */
TEST_F(TraverseMapPieces, BordersCutNothing)
{
  const std::vector<double> times = {0.1, 0.5, 0.9, 0.7, 1.3, 1.3, 0.2, 2.1};
  writeText(scratch_ / "bend.rawlog", drivenVelodyneLog(times));
  const std::string log = scratch_ / "bend.rawlog";
  const std::string ini_text = iniOf("robot_pose", "extent = growing\n");
  ASSERT_EQ(map("whole", log, ini_text).exit_code, 0);
  EXPECT_GT(metricsOf(scratch_ / "whole")["stamps"]["backward"], 1);
  EXPECT_EQ(metricsOf(scratch_ / "whole")["deskew"]["corrected"], 7) << "one stands twice";
  for (int k = 1; k <= 5; ++k)
  {
    mapPiece(k, 5, log, ini_text);
  }
  const Finished merged = merge({"1", "2", "3", "4", "5"}, "merged");
  ASSERT_EQ(merged.exit_code, 0) << merged.err;
  EXPECT_EQ(archive("merged"), archive("whole"));
}

TEST_F(TraverseMapPieces, MayHaveNoScanInThem)
{
  writeText(scratch_ / "bend.rawlog", drivenVelodyneLog({0.1, 0.5}));
  const std::string log = scratch_ / "bend.rawlog";
  const std::string ini_text = iniOf("robot_pose", "extent = growing\n");
  ASSERT_EQ(map("whole", log, ini_text).exit_code, 0);
  std::vector<std::string> folders;
  for (int k = 1; k <= 14; ++k)
  {
    mapPiece(k, 14, log, ini_text);
    folders.push_back(std::to_string(k));
  }
  ASSERT_EQ(merge(folders, "merged").exit_code, 0);
  EXPECT_EQ(archive("merged"), archive("whole"));
}

TEST_F(TraverseMapPieces, OfADamagedLogAreItsMapAndPartial)
{
  const std::string bytes = readText(mrptData(kLaserLog));
  writeText(scratch_ / "cut.rawlog", bytes.substr(0, bytes.size() / 2));
  const std::string log = scratch_ / "cut.rawlog";
  ASSERT_EQ(map("whole", log, laserIni()).exit_code, 5);
  for (const std::string k : {"1", "2"})
  {
    EXPECT_EQ(map(k, log, laserIni(), {"--piece", k + "/2"}).exit_code, 5);
  }
  const Finished merged = merge({"1", "2"}, "merged");
  EXPECT_EQ(merged.exit_code, 5) << merged.err;
  EXPECT_THAT(merged.err, HasSubstr("cut.rawlog"));
  EXPECT_EQ(archive("merged"), archive("whole"));
}

TEST_F(TraverseMapPieces, RunAgainFromTheirOwnIni)
{
  mapTwoPieces();
  const Finished again = traverseMap(
      {scratch_ / "2" / "config.ini", "--piece", "2/2", "--output", scratch_ / "again", "--quiet"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(archive("again"), archive("2"));
}
}  // namespace
