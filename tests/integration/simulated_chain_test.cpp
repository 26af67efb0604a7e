// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// traverse-sim -> traverse-map (ini/simulated.ini) -> traverse-evaluate, as a user types them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <support/scratch_folder.h>
#include <support/traverse_evaluate.h>
#include <support/traverse_map.h>

namespace
{
using namespace traverse;
using namespace traverse::testing;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

/** A yard with a house, a box, a wall, ruts, and a car that passes; less than two seconds of it. */
constexpr const char* kYard =
    "[Scene]\nmin_x_m = -14\nmax_x_m = 14\nmin_y_m = -9\nmax_y_m = 9\n"
    "[Terrain_00]\nkind = roughness\nheight_m = 0.006\n"
    "[Terrain_01]\nkind = ruts\nx_m = -8\ny_m = -3\nlength_m = 16\nheight_m = 0.09\n"
    "[Object_00]\nkind = box\nx_m = 2\ny_m = 6\nlength_m = 8\nwidth_m = 3\nheight_m = 3\n"
    "[Object_01]\nkind = box\nx_m = -6\ny_m = 3\nlength_m = 2\nwidth_m = 1\nheight_m = 1.2\n"
    "[Object_02]\nkind = wall\nx_m = -8\ny_m = -6.5\nlength_m = 14\nheight_m = 0.8\n"
    "[Object_03]\nkind = vehicle\ntrack_xs_m = 12 -12\ntrack_ys_m = -4.5 -4.5\nspeed_mps = 7\n"
    "[Drive]\nxs_m = -6 6\nys_m = 0 0\nspeed_mps = 7\naccel_mps2 = 0\n"
    "[Lidar_00]\nmodel = HDL-32E\nmax_range_m = 20\n"
    "[Ins]\nnoise_z_m = 0.005\n";

Finished traverseSim(const std::vector<std::string>& arguments)
{
  std::vector<std::string> command = {std::string(TRAVERSE_BINARY_DIR) + "/bin/traverse-sim"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return run(command, {"DISPLAY="});
}

/** World and run are made once. */
class SimulatedChain : public ::testing::Test
{
 protected:
  static void SetUpTestSuite()
  {
    shared_folder = std::make_unique<ScratchFolder>();
    formats::writeFile(scene(), kYard);
    simulated = traverseSim({scene(), "--seed", "3", "--output", world()});
    mapped = traverseMap(
        {ini("simulated"), "--rawlog", world() / "log.rawlog", "--output", *shared_folder / "run",
         "--set", "traverse-map.pictures=false", "--set", "traverse-map.scene=false", "--set",
         "traverse-map.snapshot_every_s=0.4", "--set", "traverse-map.snapshot_classes=true"});
  }

  static void TearDownTestSuite() { shared_folder.reset(); }

  void SetUp() override
  {
    ASSERT_EQ(simulated.exit_code, 0) << simulated.err;
    ASSERT_EQ(mapped.exit_code, 0) << mapped.err;
    fs::copy(*shared_folder / "run", runFolder(), fs::copy_options::recursive);
    fs::create_directory(truth());
    for (const auto& entry : fs::directory_iterator(world()))
    {
      if (entry.path().extension() != ".rawlog" && entry.is_regular_file())
      {
        fs::copy(entry.path(), truth());
      }
    }
  }

  static fs::path scene() { return *shared_folder / "yard.ini"; }

  static fs::path world() { return *shared_folder / "world"; }

  fs::path runFolder() const { return scratch_.path() / "run"; }

  fs::path truth() const { return scratch_.path() / "truth"; }

  Finished evaluated() const { return traverseEvaluate({runFolder(), truth()}); }

  /** Exit code 4, a message with this text, the report as it was. */
  void expectRefused(const std::string& why) const
  {
    const std::string before = readText(runFolder() / "report.html");
    const Finished refused = evaluated();
    EXPECT_EQ(refused.exit_code, 4) << refused.err;
    EXPECT_THAT(refused.err, HasSubstr(why));
    EXPECT_EQ(refused.out, "");
    EXPECT_EQ(readText(runFolder() / "report.html"), before);
  }

  ScratchFolder scratch_;
  static std::unique_ptr<ScratchFolder> shared_folder;
  static Finished simulated;
  static Finished mapped;
};

std::unique_ptr<ScratchFolder> SimulatedChain::shared_folder;
Finished SimulatedChain::simulated;
Finished SimulatedChain::mapped;

TEST_F(SimulatedChain, FindsWhatIsThere)
{
  const Finished ran = evaluated();
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const auto json = nlohmann::json::parse(ran.out);
  const auto& map = json["maps"][0];
  EXPECT_GT(map["classes"]["cells"], 5000);  // of 12600; the rest is hidden or has few points
  // bounds of a working chain: a frame that is off by a cell, or a truth that is turned, is far
  // below them
  EXPECT_GT(map["classes"]["mean_accuracy"], 0.8);
  EXPECT_GT(map["classes"]["by_class"]["flat"]["recall"], 0.95);
  EXPECT_GT(map["obstacles"]["cell_recall"], 0.9);
  EXPECT_EQ(map["obstacles"]["object_recall"], 1.0);
  EXPECT_LT(map["obstacles"]["phantom_share"], 0.1);
  EXPECT_LT(json["trajectory"]["ate_as_they_are_m"], 0.03);  // twice the INS's noise
}

TEST_F(SimulatedChain, TellsHowLongGhostsLast)
{
  const auto ghosts = nlohmann::json::parse(evaluated().out)["maps"][0]["ghosts"];
  // 12 m of a car's way, 1.8 m wide, in cells of 0.04 m2; the map forgets nothing
  EXPECT_GT(ghosts["departures"], 300);
  EXPECT_GT(ghosts["ghosts"], 30);
  EXPECT_GE(ghosts["never_cleared"], 30);
  EXPECT_LE(ghosts["p50_s"], ghosts["p95_s"]);
  EXPECT_LE(ghosts["p95_s"], ghosts["worst_s"]);
  EXPECT_GT(ghosts["worst_s"], 1);
  EXPECT_LE(ghosts["worst_s"], 1.8);  // the recording's end
}

TEST_F(SimulatedChain, ReportHasTheScores)
{
  ASSERT_EQ(evaluated().exit_code, 0);
  const std::string report = readText(runFolder() / "report.html");
  EXPECT_THAT(report, HasSubstr("<h2>Against the truth</h2>"));
  EXPECT_THAT(report, HasSubstr("How long cells stay obstacles"));
  EXPECT_THAT(report, HasSubstr("ATE, as they are"));
}

TEST_F(SimulatedChain, TruthOfAnotherSceneIsRefused)
{
  const fs::path other = scratch_.path() / "other";
  ASSERT_EQ(
      traverseSim({scene(), "--output", other, "--set", "Drive.xs_m=-6 6", "--set",
                   "Drive.ys_m=-2.5 -2.5", "--set", "Lidar_00.dead_after_s=0.1"})
          .exit_code,
      0);
  fs::remove_all(truth());
  fs::rename(other, truth());
  expectRefused("another scene");
}

TEST_F(SimulatedChain, TruthOfAnotherPlaceIsRefused)
{
  fs::remove(truth() / "trajectory.tum");
  const fs::path other = scratch_.path() / "other";
  ASSERT_EQ(
      traverseSim({scene(), "--output", other, "--set", "Scene.min_x_m=100", "--set",
                   "Scene.max_x_m=128", "--set", "Drive.xs_m=105 115", "--set",
                   "Lidar_00.dead_after_s=0.1"})
          .exit_code,
      0);
  fs::remove_all(truth());
  fs::rename(other, truth());
  fs::remove(truth() / "trajectory.tum");
  expectRefused("no points in any cell of this truth");
}

TEST_F(SimulatedChain, DamageAndMissingFilesAreRefused)
{
  const std::string classes = readText(truth() / "truth_class.tif");
  formats::writeFile(truth() / "truth_class.tif", classes.substr(0, classes.size() / 2));
  expectRefused("truth_class.tif");
  fs::remove(truth() / "truth_class.tif");
  expectRefused("truth_class.tif");
  formats::writeFile(truth() / "truth_class.tif", classes);
  formats::writeFile(truth() / "moving.geojson", "{\"type\": \"FeatureCollection\", ");
  expectRefused("moving.geojson");
  fs::remove(truth() / "moving.geojson");
  fs::resize_file(runFolder() / "snapshot_0002_class.tif", 100);
  EXPECT_EQ(evaluated().exit_code, 0) << "nothing that moves, so no snapshot is read";
}

TEST_F(SimulatedChain, DamagedSnapshotIsRefused)
{
  fs::resize_file(runFolder() / "snapshot_0002_class.tif", 100);
  expectRefused("snapshot_0002_class.tif");
  fs::remove(runFolder() / "snapshot_0002_class.tif");
  expectRefused("snapshot_0002_class.tif");
  formats::writeFile(runFolder() / "metrics.json", "{\"snapshots\": 5, \"x\": [}");
  expectRefused("metrics.json");
  formats::writeFile(
      runFolder() / "metrics.json",
      R"({"snapshots": [{"map": "map.traverse", "file": "../x.tif", "time_s": 1}]})");
  expectRefused("outside its folder");
}

TEST_F(SimulatedChain, TruthIsWrittenAtTheTimesAskedFor)
{
  const fs::path out = scratch_.path() / "times";
  ASSERT_EQ(
      traverseSim({scene(), "--output", out, "--set", "Truth.at_s=0.5 1.5", "--set",
                   "Lidar_00.dead_after_s=0.1"})
          .exit_code,
      0);
  const std::string first = readText(out / "truth_class_at_0.5_s.tif");
  const std::string last = readText(out / "truth_class.tif");
  EXPECT_NE(first, last) << "the car is elsewhere";
  EXPECT_TRUE(fs::exists(out / "footprints_at_0.5_s.geojson"));
  EXPECT_NE(readText(out / "scene.ini").find("at_s = 0.5 1.5"), std::string::npos);
}

TEST_F(SimulatedChain, TruthThatCannotBeIsRefusedBeforeAnythingIsMade)
{
  const auto refused = [&](const std::string& assignment, const std::string& why)
  {
    const Finished bad =
        traverseSim({scene(), "--output", scratch_.path() / "bad", "--set", assignment, "--quiet"});
    EXPECT_EQ(bad.exit_code, 3) << bad.err;
    EXPECT_THAT(bad.err, HasSubstr(why));
    EXPECT_FALSE(fs::exists(scratch_.path() / "bad"));
  };
  refused("Truth.at_s=9", "up to the end of the recording");
  refused("Truth.at_s=1 1", "times that grow");
  refused("Truth.cell_size_m=0.2005", "whole millimetres");
  refused("Truth.small_max_m=0.02", "small_max_m");
  refused("Truth.cellsize=1", "unknown key");
  refused("Drive.xs_m=-20 20", "start");
}

TEST_F(SimulatedChain, EverySceneOfTheHouseIsTaken)
{
  for (const auto& entry : fs::directory_iterator(fs::path(TRAVERSE_SOURCE_DIR) / "ini" / "scenes"))
  {
    const Finished checked = traverseSim({entry.path(), "--check-config"});
    const bool lacks_data = entry.path().stem() == "argoverse_ground" &&
                            checked.err.find("ground_height") != std::string::npos;
    EXPECT_TRUE(checked.exit_code == 0 || lacks_data) << entry.path() << ": " << checked.err;
  }
}

TEST_F(SimulatedChain, DefaultsAreASceneFile)
{
  const Finished defaults = traverseSim({"--print-defaults"});
  ASSERT_EQ(defaults.exit_code, 0);
  for (const char* section :
       {"[Scene]", "[Terrain_00]", "[Object_00]", "[Random]", "[Vehicle]", "[Drive]", "[Lidar_00]",
        "[Ins]", "[Odometry]", "[Truth]"})
  {
    EXPECT_THAT(defaults.out, HasSubstr(section));
  }
  formats::writeFile(scratch_.path() / "defaults.ini", defaults.out);
  const Finished checked = traverseSim({scratch_.path() / "defaults.ini", "--check-config"});
  EXPECT_EQ(checked.exit_code, 0) << checked.err;
}
}  // namespace
