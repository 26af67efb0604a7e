// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// The program, its log as our reader and stock programs see it, and what kill -9 leaves.
#include "support/log_reading.h"
#include "support/process.h"
#include "support/traverse_import.h"

#include <traverse/formats/gzip.h>
#include <traverse/formats/safe_file.h>
#include <traverse/formats/trajectory.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstring>
#include <fstream>
#include <map>
#include <thread>

namespace traverse::testing
{
namespace
{
namespace fs = std::filesystem;

/** Seven seconds, so two parts, of a small lidar. */
constexpr const char* kIni =
    "[Scene]\n"
    "min_x_m = -30\n"
    "max_x_m = 30\n"
    "[Object_00]\n"
    "kind = box\n"
    "x_m = 0\ny_m = 9\n"
    "[Drive]\n"
    "xs_m = -25 0 25\n"
    "ys_m = 0 5 0\n"
    "duration_s = 7\n"
    "[Lidar_00]\n"
    "label = TOP\n"
    "model = VLP-16\n"
    "max_range_m = 30\n"
    "rain_share = 0.01\n";

std::vector<std::string> simCommand(const fs::path& ini, const fs::path& output)
{
  return {
      std::string(TRAVERSE_BINARY_DIR) + "/bin/traverse-sim",
      ini.string(),
      "--output",
      output.string(),
      "--seed",
      "7"};
}

Finished simulate(
    const fs::path& ini, const fs::path& output, const std::vector<std::string>& options = {})
{
  std::vector<std::string> arguments = simCommand(ini, output);
  arguments.insert(arguments.end(), options.begin(), options.end());
  return run(arguments);
}

/** Every file's bytes by its name. */
std::map<std::string, std::string> filesIn(const fs::path& folder)
{
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
  {
    if (entry.is_regular_file())
    {
      files[fs::relative(entry.path(), folder).string()] = readText(entry.path());
    }
  }
  return files;
}

std::vector<uint32_t> labelsIn(const fs::path& file)
{
  const std::string bytes = readText(file);
  std::vector<uint32_t> labels(bytes.size() / sizeof(uint32_t));
  std::memcpy(labels.data(), bytes.data(), labels.size() * sizeof(uint32_t));
  return labels;
}

/** Kills a run of this ini when its first part is there; false where that never came. */
bool killAfterFirstPart(const fs::path& ini, const fs::path& output)
{
  const fs::path first_part = fs::path(output.string() + ".parts") / "000000.log.gz";
  std::vector<std::string> command = simCommand(ini, output);
  command.insert(command.end(), {"--threads", "1"});
  Process killed(command);
  for (int i = 0; i < 3000 && !fs::exists(first_part) && killed.running(); ++i)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  killed.signal(SIGKILL);
  return killed.wait(std::chrono::seconds(10)).exit_code == 128 + SIGKILL && fs::exists(first_part);
}

/** A raster of 2 x 2 nodes that are 100 m apart, the last one so high. */
void writeRaster(const fs::path& folder, float height_m)
{
  const std::array<float, 4> heights = {0, 0, 0, height_m};
  std::string bytes(sizeof heights, '\0');
  std::memcpy(bytes.data(), heights.data(), bytes.size());
  formats::writeFile(folder / "hill_2x2_float32.raw.gz", formats::gzip(bytes));
  formats::writeFile(folder / "hill.json", R"({"R": [1, 0, 0, 1], "t": [50, 50], "s": 0.01})");
}

/** One run that all tests look at. */
class TraverseSim : public ::testing::Test
{
 protected:
  static void SetUpTestSuite()
  {
    shared_folder = std::make_unique<ScratchFolder>();
    writeText(ini(), kIni);
    first_run = simulate(ini(), output(), {"--threads", "1"});
  }

  static void TearDownTestSuite() { shared_folder.reset(); }

  void SetUp() override { ASSERT_EQ(first_run.exit_code, 0) << first_run.err; }

  static fs::path ini() { return *shared_folder / "scene.ini"; }

  static fs::path output() { return *shared_folder / "out"; }

  static std::unique_ptr<ScratchFolder> shared_folder;
  static Finished first_run;
};

std::unique_ptr<ScratchFolder> TraverseSim::shared_folder;
Finished TraverseSim::first_run;

TEST_F(TraverseSim, LabelsEveryPointThatOurReaderMakesOfItsLog)
{
  observations::ObservationParams sensors;
  sensors.min_range_m = 0;
  sensors.max_range_m = 200;
  const LogReading reading = readLog(output() / "log.rawlog", sensors);
  ASSERT_EQ(reading.scans.size(), 69U);
  size_t raindrops = 0;
  for (size_t i = 0; i < reading.scans.size(); ++i)
  {
    const points::ScanBuffer& scan = reading.scans[i].scan;
    const std::string name = std::to_string(1'000'000 + i).substr(1) + ".label";
    const std::vector<uint32_t> labels = labelsIn(output() / "labels" / name);
    ASSERT_EQ(labels.size(), scan.size()) << name;
    raindrops += static_cast<size_t>(std::count(labels.begin(), labels.end(), 0U));
  }
  EXPECT_GT(raindrops, 500U);
}

TEST_F(TraverseSim, HasALogThatStockProgramsRead)
{
  const std::string info = stockInfo(output() / "log.rawlog");
  EXPECT_NE(info.find("Overall number of objects         : 561"), std::string::npos) << info;
}

TEST_F(TraverseSim, WritesItsTrajectoryAndWhatThingsAre)
{
  const auto poses = formats::readTrajectory(output() / "trajectory.tum");
  EXPECT_EQ(poses.size(), 701U);
  EXPECT_EQ(readText(output() / "objects.csv").substr(0, 26), "number,name,label,material");
  EXPECT_NE(readText(output() / "metrics.json").find("\"turns\": 69"), std::string::npos);
}

TEST_F(TraverseSim, GivesTheSameBytesWithTwoThreadsAndFromItsOwnIni)
{
  const fs::path again = *shared_folder / "again";
  const Finished second = simulate(output() / "scene.ini", again, {"--threads", "2", "--quiet"});
  ASSERT_EQ(second.exit_code, 0) << second.err;
  EXPECT_EQ(second.err, "");
  EXPECT_TRUE(filesIn(again) == filesIn(output()));
}

TEST_F(TraverseSim, KilledGoesOnWhereItWas)
{
  const fs::path resumed = *shared_folder / "resumed";
  const fs::path first_part = *shared_folder / "resumed.parts" / "000000.log.gz";
  ASSERT_TRUE(killAfterFirstPart(ini(), resumed));
  EXPECT_FALSE(fs::exists(resumed));
  const auto written = fs::last_write_time(first_part);
  const std::string bytes = readText(first_part);
  const Finished finished = simulate(ini(), resumed);
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_TRUE(filesIn(resumed) == filesIn(output()));
  EXPECT_EQ(readText(resumed / "log.rawlog").substr(0, bytes.size()), bytes);
  EXPECT_FALSE(fs::exists(first_part));
  EXPECT_LT(written, fs::last_write_time(resumed / "log.rawlog"));
}

TEST_F(TraverseSim, MakesDamagedPartsAgain)
{
  ASSERT_TRUE(killAfterFirstPart(ini(), *shared_folder / "whole"));
  const fs::path parts = *shared_folder / "whole.parts";
  const auto finish = [&](const char* name, const std::string& file, uintmax_t size)
  {
    const fs::path damaged = *shared_folder / (std::string(name) + ".parts");
    fs::copy(parts, damaged);
    fs::resize_file(damaged / file, size);
    const Finished finished = simulate(ini(), *shared_folder / name);
    EXPECT_EQ(finished.exit_code, 0) << name << finished.err;
    EXPECT_TRUE(filesIn(*shared_folder / name) == filesIn(output())) << name;
  };
  finish("no_log", "000000.log.gz", 0);
  finish("cut_labels", "000000.labels", fs::file_size(parts / "000000.labels") / 2);
}

TEST_F(TraverseSim, DoesNotMixPartsOfAnotherRaster)
{
  const fs::path hilly = *shared_folder / "hilly.ini";
  writeText(
      hilly, std::string(kIni) +
                 "[Terrain_00]\nkind = raster\nfile = hill_2x2_float32.raw.gz\n"
                 "transform_file = hill.json\n");
  writeRaster(shared_folder->path(), 1);
  ASSERT_TRUE(killAfterFirstPart(hilly, *shared_folder / "mixed"));
  writeRaster(shared_folder->path(), 4);
  for (const char* name : {"mixed", "fresh"})
  {
    const Finished finished = simulate(hilly, *shared_folder / name);
    ASSERT_EQ(finished.exit_code, 0) << finished.err;
  }
  EXPECT_TRUE(filesIn(*shared_folder / "mixed") == filesIn(*shared_folder / "fresh"));
}

TEST_F(TraverseSim, DoesNotMixPartsOfAnotherRun)
{
  const fs::path other = *shared_folder / "other";
  fs::create_directory(*shared_folder / "other.parts");
  writeText(*shared_folder / "other.parts" / "made_of.txt", "another run");
  writeText(*shared_folder / "other.parts" / "000000.log.gz", "another log");
  ASSERT_EQ(simulate(ini(), other).exit_code, 0);
  EXPECT_TRUE(filesIn(other) == filesIn(output()));
}

TEST_F(TraverseSim, LeavesFoldersAloneThatAreNotItsOwn)
{
  const fs::path there = *shared_folder / "there";
  fs::create_directory(*shared_folder / "there.parts");
  writeText(*shared_folder / "there.parts" / "letter.txt", "mine");
  EXPECT_EQ(simulate(ini(), there).exit_code, 1);
  EXPECT_EQ(readText(*shared_folder / "there.parts" / "letter.txt"), "mine");
  EXPECT_EQ(simulate(ini(), output()).exit_code, 1);  // --force replaces it
}

TEST_F(TraverseSim, RefusesIniFilesThatAreWrong)
{
  const auto refused = [&](const std::string& text, const std::string& why)
  {
    writeText(*shared_folder / "bad.ini", text);
    const Finished bad = simulate(*shared_folder / "bad.ini", *shared_folder / "bad");
    EXPECT_EQ(bad.exit_code, 3) << bad.err;
    EXPECT_NE(bad.err.find(why), std::string::npos) << bad.err;
    EXPECT_FALSE(fs::exists(*shared_folder / "bad"));
  };
  refused("[Lidar_00]\nmodle = VLP-16\n", "bad.ini:2");
  refused("[Lidar_00]\nmodel = VLP-17\n", "HDL-32E | VLP-16 | VLP-32C");
  refused("[Lidar_00]\nmode = dual\n", "strongest | last");
  refused("[Lidar_01]\nmodel = VLP-16\n", "[Lidar_00]");
  refused("[Lidar_00]\nlabel = A\n[Lidar_01]\nlabel = A\n", "different names");
  refused("[Drive]\nspeed_mps = -1\n", "speed_mps");
  refused("[Drive]\nxs_m = 1 2\nys_m = 1\n", "xs_m");
  refused("[Rain]\nheavy = true\n", "Rain");
  refused(
      "[Scene]\nmin_x_m = -2000\nmax_x_m = 2000\nmin_y_m = -2000\nmax_y_m = 2000\n", "50000000");
}

TEST_F(TraverseSim, TakesSeedsOf64Bits)
{
  const std::string program = std::string(TRAVERSE_BINARY_DIR) + "/bin/traverse-sim";
  const auto checked = [&](const std::string& seed) {
    return run({program, ini().string(), "--check-config", "--seed", seed});
  };
  EXPECT_EQ(checked("18446744073709551615").exit_code, 0);
  for (const char* seed : {"-1", "99999999999999999999999", "1x", "0x10", "1.5"})
  {
    const Finished refused = checked(seed);
    EXPECT_EQ(refused.exit_code, 2) << seed;
    EXPECT_NE(refused.err.find("--seed"), std::string::npos) << refused.err;
  }
}

TEST_F(TraverseSim, ChecksAConfigurationWithoutWritingAnything)
{
  const std::string program = std::string(TRAVERSE_BINARY_DIR) + "/bin/traverse-sim";
  EXPECT_EQ(run({program, ini().string(), "--check-config"}).exit_code, 0);
  EXPECT_EQ(
      run({program, ini().string(), "--check-config", "--set", "Ins.rate_hz=-1"}).exit_code, 3);
  EXPECT_EQ(run({program, ini().string()}).exit_code, 2);
  const Finished defaults = run({program, "--print-defaults"});
  EXPECT_EQ(defaults.exit_code, 0);
  EXPECT_NE(defaults.out.find("[Lidar_00]"), std::string::npos);
}
}  // namespace
}  // namespace traverse::testing
