// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// traverse-map from ini and log to files, on the logs that Debian ships.

#include "support/traverse_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace
{
using namespace traverse::testing;
using ::testing::AllOf;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

const std::vector<std::string> kLayers = {
    "traversability_class", "traversability_index", "height_mean", "height_deviation", "slope_deg",
    "height_variance",      "point_count"};

uint64_t cells(const nlohmann::json& metrics, const std::string& name)
{
  return metrics["maps"][0]["cells_by_class"].value(name, uint64_t{0});
}

void expectAllFiles(const fs::path& folder)
{
  for (const std::string& layer : kLayers)
  {
    EXPECT_GT(fs::file_size(folder / (layer + ".tif")), 100U) << layer;
  }
  for (const char* file :
       {"traversability_class.pgm", "traversability_class.yaml", "traversability_index.pgm",
        "traversability_index.yaml", "map_top.png", "map_3d.png", "map.3Dscene", "map.traverse",
        "report.html"})
  {
    EXPECT_GT(fs::file_size(folder / file), 20U) << file;
  }
}

TEST(TraverseMap, MapsTheVlp16Scan)
{
  const ScratchFolder scratch;
  const Finished ran = traverseMap({ini("vlp16"), "--output", scratch / "out"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(ran.out, (scratch / "out").string() + "/report.html\n")
      << "results on stdout, nothing else";
  expectAllFiles(scratch / "out");
  const auto metrics = metricsOf(scratch / "out");
  EXPECT_EQ(metrics["points"], 22591)
      << "every valid return of the packets; stock MRPT finds 11,305";
  EXPECT_TRUE(metrics["complete"]);
  EXPECT_GT(cells(metrics, "flat"), 50U);
  EXPECT_GT(cells(metrics, "obstacle"), 200U);
}

TEST(TraverseMap, MapsTheRgbdFrame)
{
  const ScratchFolder scratch;
  const Finished ran = traverseMap({ini("rgbd"), "--output", scratch / "out"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  expectAllFiles(scratch / "out");
  const auto metrics = metricsOf(scratch / "out");
  EXPECT_EQ(metrics["points"], 273225);
  EXPECT_GT(cells(metrics, "obstacle"), 200U);
}

TEST(TraverseMap, MapsTheLaserDrive)
{
  const ScratchFolder scratch;
  const Finished ran = traverseMap({ini("laser2d"), "--output", scratch / "out"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  expectAllFiles(scratch / "out");
  const auto metrics = metricsOf(scratch / "out");
  EXPECT_EQ(metrics["scans"], 225);
  EXPECT_EQ(metrics["pose_source"], "icp_2d");
  EXPECT_GT(fs::file_size(scratch / "out" / "trajectory.tum"), 225U * 20);
  EXPECT_EQ(metrics["maps"][0]["scans"], 225);
}

TEST(TraverseMap, LayersLieWhereTheyShould)
{
  const ScratchFolder scratch;
  ASSERT_EQ(traverseMap({ini("vlp16"), "--output", scratch / "out"}).exit_code, 0);
  const Finished info =
      run({"gdalinfo", "-json", (scratch / "out" / "traversability_class.tif").string()});
  const auto json = nlohmann::json::parse(info.out);
  EXPECT_DOUBLE_EQ(json["geoTransform"][1], 0.25);
  EXPECT_DOUBLE_EQ(json["geoTransform"][5], -0.25) << "north up";
  EXPECT_EQ(json["bands"][0]["type"], "Byte");
}

TEST(TraverseMap, TheSameRunGivesTheSameBytes)
{
  const ScratchFolder scratch;
  for (const char* name : {"a", "b"})
  {
    ASSERT_EQ(traverseMap({ini("vlp16"), "--output", scratch / name, "--quiet"}).exit_code, 0);
  }
  for (const char* file :
       {"map.traverse", "traversability_class.tif", "height_mean.tif", "traversability_class.pgm"})
  {
    EXPECT_EQ(readText(scratch / "a" / file), readText(scratch / "b" / file)) << file;
  }
}

TEST(TraverseMap, ADecimalCommaLocaleGivesTheSameBytes)
{
  const ScratchFolder scratch;
  const Finished locale = run({"localedef", "-i", "de_DE", "-f", "UTF-8", scratch / "de_DE.UTF-8"});
  if (!fs::exists(scratch / "de_DE.UTF-8"))
  {
    GTEST_SKIP() << "SKIPPED: localedef cannot make de_DE here: " << locale.err;
  }
  ASSERT_EQ(traverseMap({ini("vlp16"), "--output", scratch / "c"}).exit_code, 0);
  const Finished german = traverseMap(
      {ini("vlp16"), "--output", scratch / "de"},
      {"LOCPATH=" + scratch.path().string(), "LC_ALL=de_DE.UTF-8", "LANG=de_DE.UTF-8"});
  ASSERT_EQ(german.exit_code, 0) << german.err;
  EXPECT_EQ(readText(scratch / "c" / "map.traverse"), readText(scratch / "de" / "map.traverse"));
}

TEST(TraverseMap, SaysHelpAndVersionWithoutADisplay)
{
  const Finished help = traverseMap({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_THAT(help.out, AllOf(HasSubstr("--rawlog"), HasSubstr("--set"), HasSubstr("Exit codes")));
  const Finished version = traverseMap({"--version"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_THAT(version.out, HasSubstr("traverse-map "));
}

TEST(TraverseMap, PrintedDefaultsAreAConfigurationItTakes)
{
  const ScratchFolder scratch;
  const Finished defaults = traverseMap({"--print-defaults"});
  ASSERT_EQ(defaults.exit_code, 0);
  writeText(scratch / "defaults.ini", defaults.out);
  const Finished checked = traverseMap({scratch / "defaults.ini", "--check-config"});
  EXPECT_EQ(checked.exit_code, 0) << checked.err;
}
}  // namespace
