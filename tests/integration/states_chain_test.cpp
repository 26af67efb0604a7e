// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// traverse-sim -> traverse-map (ini/multi_lidar.ini) -> traverse-evaluate: a map of states, the
// same for any number of threads.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <support/scratch_folder.h>
#include <support/traverse_evaluate.h>
#include <support/traverse_map.h>

namespace
{
using namespace traverse;
using namespace traverse::testing;
using ::testing::HasSubstr;
using ::testing::Not;

/** A yard with a box, a wall, a ditch and a car that passes; two lidars, three seconds. */
constexpr const char* kYard =
    "[Scene]\nmin_x_m = -14\nmax_x_m = 14\nmin_y_m = -9\nmax_y_m = 9\n"
    "[Terrain_00]\nkind = ditch\nx_m = -5\ny_m = 3\nlength_m = 10\nwidth_m = 1.2\nheight_m = 0.8\n"
    "[Object_00]\nkind = box\nx_m = 2\ny_m = 6\nlength_m = 8\nwidth_m = 2\nheight_m = 3\n"
    "[Object_01]\nkind = wall\nx_m = -8\ny_m = -7.5\nlength_m = 14\nheight_m = 0.8\n"
    "[Object_02]\nkind = vehicle\ntrack_xs_m = 12 -12\ntrack_ys_m = -4.5 -4.5\nspeed_mps = 7\n"
    "[Drive]\nxs_m = -6 6\nys_m = 0 0\nspeed_mps = 4\naccel_mps2 = 0\n"
    "[Vehicle]\nfootprint_xs_m = -2.2 2.2 2.2 -2.2\nfootprint_ys_m = -0.9 -0.9 0.9 0.9\n"
    "height_m = 2\n"
    "[Lidar_00]\nlabel = ROOF\nmodel = VLP-32C\nz_m = 1.9\n"
    "[Lidar_01]\nlabel = LEFT\nmodel = VLP-16\nx_m = 2\ny_m = 0.9\nz_m = 0.8\nyaw_deg = 60\n"
    "pitch_deg = 12\nstart_s = 0.04\n"
    "[Ins]\nnoise_z_m = 0.005\n";

class StatesChain : public ::testing::Test
{
 protected:
  void simulate(const std::vector<std::string>& more = {}) const
  {
    formats::writeFile(scratch_ / "yard.ini", kYard);
    std::vector<std::string> command = {
        std::string(TRAVERSE_BINARY_DIR) + "/bin/traverse-sim",
        scratch_ / "yard.ini",
        "--seed",
        "1",
        "--output",
        world()};
    command.insert(command.end(), more.begin(), more.end());
    const Finished simulated = run(command, {"DISPLAY="});
    ASSERT_EQ(simulated.exit_code, 0) << simulated.err;
  }

  void map(const std::string& folder, const std::vector<std::string>& settings) const
  {
    std::vector<std::string> arguments = {
        ini("multi_lidar"), "--rawlog", world() + "/log.rawlog", "--output", scratch_ / folder};
    for (const char* setting : {"traverse-map.pictures=false", "traverse-map.scene=false"})
    {
      arguments.insert(arguments.end(), {"--set", setting});
    }
    for (const std::string& setting : settings)
    {
      arguments.insert(arguments.end(), {"--set", setting});
    }
    const Finished mapped = traverseMap(arguments);
    ASSERT_EQ(mapped.exit_code, 0) << mapped.err;
  }

  std::string world() const { return scratch_ / "world"; }

  ScratchFolder scratch_;
};

/** All files of a run's folder but those that hold times of the run and its options. */
std::map<std::string, std::string> resultsIn(const std::filesystem::path& folder)
{
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    const std::string name = entry.path().filename();
    if (name != "metrics.json" && name != "report.html" && name != "config.ini")
    {
      files[name] = readText(entry.path());
    }
  }
  return files;
}

TEST_F(StatesChain, AMapOfStatesIsHeldAgainstTheTrueStates)
{
  ASSERT_NO_FATAL_FAILURE(simulate());
  ASSERT_NO_FATAL_FAILURE(
      map("run", {"traverse-map.snapshot_every_s=0.2", "traverse-map.snapshot_classes=true"}));
  const std::filesystem::path run_folder = scratch_ / "run";

  const Finished evaluated = traverseEvaluate({run_folder.string(), world()});
  ASSERT_EQ(evaluated.exit_code, 0) << evaluated.err;
  const auto map = nlohmann::json::parse(evaluated.out)["maps"][0];
  EXPECT_FALSE(map.contains("classes"));
  for (const char* rule : {"occupancy", "occupancy_strict"})
  {
    EXPECT_GT(map[rule]["obstacles"], 100) << rule;
    EXPECT_GT(map[rule]["ditches"], 200) << rule;
  }
  // what is at the near sides of a box, a wall, a ditch; their far sides are hidden
  EXPECT_GT(map["occupancy"]["obstacle_recall"], 0.9);
  EXPECT_LT(map["occupancy"]["false_obstacle_rate"], 0.002);
  EXPECT_GT(map["occupancy"]["free_iou"], 0.97);
  EXPECT_GT(map["occupancy"]["ditch_recall"], 0.4);
  EXPECT_LE(
      map["occupancy_strict"]["obstacle_recall"].get<double>(),
      map["occupancy"]["obstacle_recall"].get<double>());
  // the car's 1.8 m of width, cell by cell; the obstacle's code of this map is another
  EXPECT_GT(map["ghosts"]["departures"], 500);
  EXPECT_GT(map["ghosts"]["ghosts"], 0);
  EXPECT_LT(map["ghosts"]["p50_s"], 1.0);
  const std::string report = readText(run_folder / "report.html");
  EXPECT_THAT(report, HasSubstr("Obstacles, ditches, and what is free"));
  EXPECT_THAT(report, Not(HasSubstr("Cells by true class")));
}

/** Two maps, so that a third thread has work; clouds that come late and have a clock of their own.
 */
TEST_F(StatesChain, ThreadsDoNotMatter)
{
  ASSERT_NO_FATAL_FAILURE(simulate(
      {"--set", "Drive.duration_s=1.5", "--set", "Lidar_01.clock_offset_s=0.08", "--set",
       "Lidar_01.late_s=0.15"}));
  for (const char* threads : {"1", "2", "3"})
  {
    ASSERT_NO_FATAL_FAILURE(map(
        threads,
        {std::string("traverse-map.threads=") + threads, "Maps.CWrappableMultiLidarGrid_count=2",
         "Maps_CWrappableMultiLidarGrid_01_insertOpts.cells=paper"}));
  }
  const auto one = resultsIn(scratch_ / "1");
  for (const char* name :
       {"map.traverse", "occupancy_state.tif", "sensor_mask.tif", "safety_buffer.tif",
        "map_01.traverse", "occupancy_state_01.tif"})
  {
    EXPECT_EQ(one.count(name), 1U) << name;
  }
  EXPECT_EQ(metricsOf(scratch_ / "1")["maps"][0]["scans"], metricsOf(scratch_ / "1")["scans"]);
  EXPECT_NE(one.at("map_01.traverse"), one.at("map.traverse"));
  EXPECT_TRUE(resultsIn(scratch_ / "2") == one);
  EXPECT_TRUE(resultsIn(scratch_ / "3") == one);
}
}  // namespace
