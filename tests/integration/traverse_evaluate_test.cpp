// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// traverse-evaluate on a run of traverse-map and a truth made of it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>
#include <support/scratch_folder.h>
#include <support/traverse_evaluate.h>
#include <support/traverse_map.h>

namespace
{
using namespace traverse;
using namespace traverse::testing;
using ::testing::HasSubstr;
using ::testing::Not;
namespace fs = std::filesystem;

/** One run for all tests here; each has a copy. */
class TraverseEvaluate : public ::testing::Test
{
 protected:
  static void SetUpTestSuite()
  {
    shared = new ScratchFolder;
    const Finished ran = traverseMap(
        {ini("vlp16"), "--set", "traverse-map.pictures=false", "--output", *shared / "run"});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
  }

  static void TearDownTestSuite()
  {
    delete shared;
    shared = nullptr;
  }

  void SetUp() override
  {
    fs::copy(*shared / "run", run(), fs::copy_options::recursive);
    writeTruth(truth(), truthOfRun(run()));
  }

  fs::path run() const { return scratch_.path() / "run"; }

  fs::path truth() const { return scratch_.path() / "truth"; }

  std::string report() const { return readText(run() / "report.html"); }

  Finished evaluated(std::vector<std::string> options = {}) const
  {
    options.insert(options.begin(), {run().string(), truth().string()});
    return traverseEvaluate(options);
  }

  /** Exit code 4 and a message with this text; the report as it was. */
  void expectRefused(const std::string& why) const
  {
    const std::string before = report();
    const Finished ran = evaluated();
    EXPECT_EQ(ran.exit_code, 4) << ran.err;
    EXPECT_THAT(ran.err, HasSubstr(why));
    EXPECT_EQ(ran.out, "");
    EXPECT_EQ(report(), before);
  }

  ScratchFolder scratch_;
  static ScratchFolder* shared;
};

ScratchFolder* TraverseEvaluate::shared = nullptr;

TEST_F(TraverseEvaluate, AMapIsRightAgainstItself)
{
  for (const fs::path& folder : {run(), truth()})
  {
    formats::writeFile(
        folder / "trajectory.tum", "1 0 0 0 0 0 0 1\n1.5 1 0 0 0 0 0 1\n2 2 1 0 0 0 0 1\n");
  }
  const Finished ran = evaluated({"--output", (scratch_.path() / "scores.json").string()});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const auto json = nlohmann::json::parse(ran.out);
  const auto& map = json["maps"][0];
  EXPECT_EQ(map["classes"]["mean_accuracy"], 1.0);
  EXPECT_GT(map["classes"]["cells"], 500);
  EXPECT_EQ(map["obstacles"]["cell_recall"], 1.0);
  EXPECT_EQ(map["obstacles"]["phantom_cells"], 0);
  EXPECT_EQ(map["states"]["occupied_agreement"], 1.0);
  EXPECT_LT(json["trajectory"]["ate_m"], 1e-9);
  EXPECT_EQ(json["trajectory"]["poses"], 3);
  EXPECT_EQ(readText(scratch_.path() / "scores.json"), ran.out);
}

TEST_F(TraverseEvaluate, WhatIsWrongIsCounted)
{
  layers::LayerSet wrong = truthOfRun(run());
  auto& classes = std::get<std::vector<uint8_t>>(wrong.layers[0].data);
  std::replace(classes.begin(), classes.end(), uint8_t{4}, uint8_t{1});
  writeTruth(truth(), wrong);
  const Finished ran = evaluated();
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const auto map = nlohmann::json::parse(ran.out)["maps"][0];
  EXPECT_EQ(map["obstacles"]["phantom_share"], 1.0);
  EXPECT_TRUE(map["obstacles"]["cell_recall"].is_null());
  EXPECT_LT(map["classes"]["accuracy"], 0.9);
}

TEST_F(TraverseEvaluate, ReportGetsASectionAndLosesNothing)
{
  const std::string before = report();
  ASSERT_EQ(evaluated().exit_code, 0);
  const std::string once = report();
  EXPECT_THAT(once, HasSubstr("<h2>Against the truth</h2>"));
  EXPECT_THAT(once, HasSubstr("missed obstacle"));
  EXPECT_GT(once.size(), before.size());
  ASSERT_EQ(evaluated().exit_code, 0);
  EXPECT_EQ(report(), once) << "replaced, not added twice";
  ASSERT_EQ(evaluated({"--min-returns", "50"}).exit_code, 0);
  EXPECT_NE(report(), once);
  ASSERT_EQ(evaluated({"--no-report", "--min-returns", "9"}).exit_code, 0);
}

TEST_F(TraverseEvaluate, MissingTruthIsRefused)
{
  fs::remove(truth() / "truth_state.tif");
  expectRefused("truth_state.tif");
}

TEST_F(TraverseEvaluate, DamagedTruthIsRefused)
{
  formats::writeFile(truth() / "truth_class.tif", "II*\0");
  expectRefused("truth_class.tif");
  writeTruth(truth(), truthOfRun(run()));
  formats::writeFile(truth() / "footprints.geojson", "{\"type\":");
  expectRefused("footprints.geojson");
  fs::remove(truth() / "footprints.geojson");
  formats::writeFile(truth() / "trajectory.tum", "1 2 3\n");
  expectRefused("trajectory.tum");
}

TEST_F(TraverseEvaluate, TruthOfOtherCellsIsRefused)
{
  layers::LayerSet coarse = truthOfRun(run());
  coarse.lattice.cell_mm *= 2;
  writeTruth(truth(), coarse);
  expectRefused("mm");
}

TEST_F(TraverseEvaluate, OutlinesOfTooManyCornersAreRefused)
{
  std::string corners;
  for (int i = 0; i < 200000; ++i)
  {
    const int side = i < 100000 ? 1 : -1;
    corners += fmt::format("[{},{}],", side * (30 - i % 100000 * 6e-4), side * 30);
  }
  formats::writeFile(
      truth() / "footprints.geojson",
      R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"object":2,)"
      R"("height_m":1},"geometry":{"type":"Polygon","coordinates":[[)" +
          corners + "[30,30]]]}}]}");
  expectRefused("footprints.geojson");
}

TEST_F(TraverseEvaluate, TruthOfOtherClassesIsRefused)
{
  layers::LayerSet other = truthOfRun(run());
  other.legend[1].name = "swamp";
  writeTruth(truth(), other);
  expectRefused("none of the truth's");
}

TEST_F(TraverseEvaluate, RunWithoutAMapIsRefused)
{
  fs::remove(run() / "map.traverse");
  expectRefused("no map");
}

TEST_F(TraverseEvaluate, ReportOfAnybodyElseIsLeftAlone)
{
  formats::writeFile(run() / "report.html", "<html><body>mine</body></html>");
  expectRefused("report.html");
}

TEST_F(TraverseEvaluate, UsageIsTold)
{
  EXPECT_EQ(traverseEvaluate({}).exit_code, 2);
  const Finished help = traverseEvaluate({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_THAT(help.out, HasSubstr("TRUTH_DIR"));
  EXPECT_EQ(traverseEvaluate({"--version"}).exit_code, 0);
}
}  // namespace
