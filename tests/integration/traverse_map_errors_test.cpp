// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// What traverse-map says and does where something is wrong: command line, ini, log, output.

#include "support/traverse_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <thread>

namespace
{
using namespace traverse::testing;
using ::testing::AllOf;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

class TraverseMapErrors : public ::testing::Test
{
 protected:
  /** Runs the VLP-16 ini with these arguments after it. */
  Finished vlp16(std::vector<std::string> arguments) const
  {
    arguments.insert(arguments.begin(), {ini("vlp16"), "--output", (scratch_ / "out").string()});
    return traverseMap(arguments);
  }

  /** Runs with an ini of this text. */
  Finished withIni(const std::string& text) const
  {
    writeText(scratch_ / "car.ini", text);
    return traverseMap({(scratch_ / "car.ini").string(), "--check-config"});
  }

  ScratchFolder scratch_;
};

TEST_F(TraverseMapErrors, WrongUsageIsExitTwo)
{
  EXPECT_EQ(traverseMap({}).exit_code, 2);
  EXPECT_EQ(traverseMap({"--no-such-flag"}).exit_code, 2);
  writeText(scratch_ / "maps.ini", "[Maps]\nCTraversabilityGridMap_count = 1\n");
  const Finished no_log = traverseMap({(scratch_ / "maps.ini").string()});
  EXPECT_EQ(no_log.exit_code, 2);
  EXPECT_THAT(no_log.err, HasSubstr("--rawlog"));
}

TEST_F(TraverseMapErrors, AMisspeltKeyNamesFileLineAndNearestKey)
{
  const Finished ran = withIni(
      "[Maps]\nCTraversabilityGridMap_count = "
      "1\n[Maps_CTraversabilityGridMap_00_insertOpts]\ncell_sise_m = 0.1\n");
  EXPECT_EQ(ran.exit_code, 3);
  EXPECT_THAT(
      ran.err,
      AllOf(HasSubstr("car.ini:4:"), HasSubstr("cell_sise_m"), HasSubstr("'cell_size_m'")));
}

TEST_F(TraverseMapErrors, MisspeltSectionsAndMapsAreRefused)
{
  EXPECT_THAT(
      withIni("[Maps]\nCTraversabilityGridMap_count=1\n[Vehicel]\nheight_m=1\n").err,
      HasSubstr("[Vehicle]"));
  EXPECT_THAT(
      withIni("[Maps]\nCTraversabilityGirdMap_count=1\n").err,
      HasSubstr("'CTraversabilityGridMap_count'"));
  EXPECT_EQ(withIni("[Maps]\nCTraversabilityGirdMap_count=1\n").exit_code, 3);
  EXPECT_EQ(withIni("[Vehicle]\nheight_m=1\n").exit_code, 3) << "no map was asked for";
}

TEST_F(TraverseMapErrors, CountsOutOfRangeAreRefused)
{
  const Finished ran = withIni("[Maps]\nCTraversabilityGridMap_count = -1\n");
  EXPECT_EQ(ran.exit_code, 3);
  EXPECT_THAT(ran.err, AllOf(HasSubstr("car.ini:2:"), HasSubstr("'-1'"), HasSubstr("0 to 16")));
}

TEST_F(TraverseMapErrors, ValuesOutOfRangeAreRefused)
{
  const std::string maps = "[Maps]\nCTraversabilityGridMap_count=1\n";
  for (const char* bad : {"-1", "0", "abc", "1,5", "nan", "1e999", ""})
  {
    const Finished ran =
        withIni(maps + "[Maps_CTraversabilityGridMap_00_insertOpts]\ncell_size_m = " + bad + "\n");
    EXPECT_EQ(ran.exit_code, 3) << bad;
    EXPECT_THAT(ran.err, HasSubstr("car.ini:4:")) << bad;
  }
}

TEST_F(TraverseMapErrors, KeysThatContradictEachOtherAreNamedWithTheirLine)
{
  const Finished window = withIni(
      "[Maps]\nCTraversabilityGridMap_count=1\n[Maps_CTraversabilityGridMap_00_insertOpts]\n"
      "window_m = 1\ncell_size_m = 2\n");
  EXPECT_EQ(window.exit_code, 3);
  EXPECT_THAT(window.err, AllOf(HasSubstr("car.ini:4:"), HasSubstr("window_m")));
  const Finished ranges =
      withIni("[Maps]\nCTraversabilityGridMap_count=1\n[Sensors]\nmin_range_m=5\nmax_range_m=2\n");
  EXPECT_EQ(ranges.exit_code, 3);
  EXPECT_THAT(ranges.err, AllOf(HasSubstr("car.ini:5:"), HasSubstr("max_range_m")));
  EXPECT_EQ(withIni("[Maps]\ntraversabilityGridMap_count=1\n").exit_code, 0) << "the alias";
}

TEST_F(TraverseMapErrors, MostScansWithoutAPoseIsPartial)
{
  writeText(scratch_ / "one.tum", "1136119200 0 0 0 0 0 0 1\n");
  const Finished ran = traverseMap(
      {ini("laser2d"), "--output", scratch_ / "out", "--set", "Poses.source=file", "--set",
       "Poses.file=" + (scratch_ / "one.tum").string()});
  EXPECT_EQ(ran.exit_code, 5) << ran.err;
  EXPECT_THAT(ran.err, HasSubstr("no valid pose"));
}

TEST_F(TraverseMapErrors, AJumpOfAThousandKilometresLosesNothing)
{
  const Finished odometry =
      traverseMap({ini("laser2d"), "--output", scratch_ / "a", "--set", "Poses.source=odometry"});
  ASSERT_EQ(odometry.exit_code, 0) << odometry.err;
  const double start = metricsOf(scratch_ / "a")["first_stamp_s"];
  writeText(
      scratch_ / "jump.tum", std::to_string(start) + " 0 0 0 0 0 0 1\n" +
                                 std::to_string(start + 30) + " 1000000 0 0 0 0 0 1\n");
  const Finished ran = traverseMap(
      {ini("laser2d"), "--output", scratch_ / "b", "--set", "Poses.source=file", "--set",
       "Poses.file=" + (scratch_ / "jump.tum").string(), "--set", "Poses.max_pose_age_s=20",
       "--set", "Maps_CTraversabilityGridMap_00_insertOpts.extent=growing"});
  EXPECT_EQ(ran.exit_code, 5) << ran.err;
  EXPECT_TRUE(fs::exists(scratch_ / "b" / "map.traverse"));
  EXPECT_TRUE(fs::exists(scratch_ / "b" / "traversability_class.tif"));
}

TEST_F(TraverseMapErrors, StockMapsAreLeftToMrptWithAWarning)
{
  const Finished ran = withIni(
      "[Maps]\nCTraversabilityGridMap_count=1\npointsMap_count=1\n[Maps_pointsMap_00_insertOpts]"
      "\nminDistBetweenLaserPoints=0.1\n");
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_THAT(ran.err, HasSubstr("stock MRPT map"));
}

TEST_F(TraverseMapErrors, AnUnreadableLogIsExitFour)
{
  writeText(scratch_ / "empty.rawlog", "");
  writeText(scratch_ / "text.rawlog", "this is no log, whatever its name says\n");
  for (const std::string& log :
       {(scratch_ / "missing.rawlog").string(), scratch_.path().string(),
        (scratch_ / "empty.rawlog").string(), (scratch_ / "text.rawlog").string()})
  {
    const Finished ran = vlp16({"--rawlog", log});
    EXPECT_EQ(ran.exit_code, 4) << log << ran.err;
    EXPECT_THAT(ran.err, HasSubstr(log));
    EXPECT_FALSE(fs::exists(scratch_ / "out")) << "no folder of results without results";
  }
}

TEST_F(TraverseMapErrors, LabelsThatTheLogLacksAreNamed)
{
  const Finished none = vlp16({"--set", "Sensors.sensor_labels=velodyne"});
  EXPECT_EQ(none.exit_code, 4) << none.err;
  EXPECT_THAT(none.err, HasSubstr("'velodyne', which nothing in the log has; it has 'Velodyne1"));
  const Finished some = vlp16({"--set", "Sensors.sensor_labels=Velodyne1_SCAN roof"});
  EXPECT_EQ(some.exit_code, 0) << some.err;
  EXPECT_THAT(some.err, HasSubstr("'roof', which nothing in the log has"));
}

TEST_F(TraverseMapErrors, AMissingTrajectoryIsExitFour)
{
  const Finished ran =
      vlp16({"--set", "Poses.source=file", "--set", "Poses.file=/nonexistent.tum"});
  EXPECT_EQ(ran.exit_code, 4);
  EXPECT_THAT(ran.err, HasSubstr("/nonexistent.tum"));
}

TEST_F(TraverseMapErrors, ALogWithoutTheAskedPosesSaysSo)
{
  const Finished ran = vlp16({"--set", "Poses.source=odometry"});
  EXPECT_EQ(ran.exit_code, 5);
  EXPECT_THAT(ran.err, HasSubstr("no poses of source 'odometry'"));
}

TEST_F(TraverseMapErrors, ATruncatedLogIsSavedAndMarkedPartial)
{
  const std::string whole =
      readText(mrptData("2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog"));
  writeText(scratch_ / "cut.rawlog", whole.substr(0, whole.size() / 2));
  const Finished ran = traverseMap(
      {ini("laser2d"), "--rawlog", scratch_ / "cut.rawlog", "--output", scratch_ / "out", "--set",
       "Poses.source=odometry"});
  EXPECT_EQ(ran.exit_code, 5) << ran.err;
  EXPECT_THAT(ran.err, HasSubstr("cut.rawlog"));
  const auto metrics = metricsOf(scratch_ / "out");
  EXPECT_FALSE(metrics["complete"]);
  EXPECT_GT(metrics["scans"].get<int>(), 80);
  EXPECT_LT(metrics["scans"].get<int>(), 140);
}

TEST_F(TraverseMapErrors, AnOutputFolderThatIsThereNeedsForce)
{
  ASSERT_EQ(vlp16({}).exit_code, 0);
  const std::string before = readText(scratch_ / "out" / "map.traverse");
  const Finished again =
      vlp16({"--set", "Maps_CTraversabilityGridMap_00_insertOpts.cell_size_m=0.4"});
  EXPECT_EQ(again.exit_code, 1);
  EXPECT_THAT(again.err, HasSubstr((scratch_ / "out").string()));
  EXPECT_EQ(readText(scratch_ / "out" / "map.traverse"), before);
  EXPECT_EQ(
      vlp16({"--force", "--set", "Maps_CTraversabilityGridMap_00_insertOpts.cell_size_m=0.4"})
          .exit_code,
      0);
  EXPECT_NE(readText(scratch_ / "out" / "map.traverse"), before);
}

TEST_F(TraverseMapErrors, AnOutputFolderThatCannotBeMadeIsSaidBeforeAnythingRuns)
{
  const Finished ran = traverseMap({ini("vlp16"), "--output", "/proc/no/such"});
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_THAT(ran.err, HasSubstr("/proc/no"));
}

TEST_F(TraverseMapErrors, AFullDiskIsSaidAndLeavesNoResultThatLooksWhole)
{
  const auto ran =
      traverseMapOnTinyDisk(scratch_.path(), 64, {ini("vlp16"), "--output", scratch_ / "out"});
  if (!ran)
  {
    GTEST_SKIP() << "SKIPPED: no mount namespace here";
  }
  EXPECT_EQ(ran->exit_code, 1);
  EXPECT_THAT(ran->err, HasSubstr("No space left on device"));
}

TEST_F(TraverseMapErrors, WhatWasFinishedIsSavedOnInterrupt)
{
  for (const auto& [number, code] : {std::pair{SIGINT, 130}, std::pair{SIGTERM, 143}})
  {
    const fs::path out = scratch_ / ("out" + std::to_string(code));
    Process process(
        {std::string(TRAVERSE_BINARY_DIR) + "/bin/traverse-map", ini("laser2d"), "--output", out,
         "--set", "Poses.source=odometry", "--set", "traverse-map.snapshot_every_s=0.2"});
    while (process.running() && !fs::exists(out.string() + ".partial/snapshot_0003.png"))
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    process.signal(number);
    const Finished ran = process.wait(std::chrono::seconds(60));
    EXPECT_EQ(ran.exit_code, code) << ran.err;
    const auto metrics = metricsOf(out);
    EXPECT_FALSE(metrics["complete"]);
    EXPECT_GT(metrics["scans"].get<int>(), 0);
    EXPECT_LT(metrics["scans"].get<int>(), 225);
  }
}
}  // namespace
