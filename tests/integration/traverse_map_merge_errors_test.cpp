// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// What --piece and --merge refuse, and what they say.
#include "support/map_pieces.h"

#include <gmock/gmock.h>

#include <csignal>
#include <random>
#include <thread>

namespace
{
using namespace traverse::testing;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

TEST_F(TraverseMapPieces, NeedMapsThatDoNotForget)
{
  for (const char* options : {"extent = rolling\n", "extent = growing\nmode = single_cloud\n"})
  {
    const Finished ran =
        map("x", mrptData(kLaserLog), iniOf("odometry", options), {"--piece", "1/2"});
    EXPECT_EQ(ran.exit_code, 3) << ran.err;
    EXPECT_THAT(ran.err, HasSubstr("cannot be merged"));
  }
  const Finished limited =
      map("x", mrptData(kLaserLog), laserIni(),
          {"--piece", "1/2", "--set", "traverse-map.max_scans=5"});
  EXPECT_EQ(limited.exit_code, 3);
  EXPECT_THAT(limited.err, HasSubstr("max_scans"));
}

TEST_F(TraverseMapPieces, WrongUsageIsExitTwo)
{
  for (const char* piece : {"0/3", "4/3", "1", "1/", "/2", "a/b", "1/2x", "-1/2", "1/99999999999"})
  {
    EXPECT_EQ(map("x", mrptData(kLaserLog), laserIni(), {"--piece", piece}).exit_code, 2) << piece;
  }
  EXPECT_EQ(traverseMap({"--merge", scratch_ / "a"}).exit_code, 2) << "no --output";
  EXPECT_EQ(traverseMap({"--merge", scratch_ / "a", "--piece", "1/2"}).exit_code, 2);
}

TEST_F(TraverseMapPieces, MissingAndRepeatedOnesAreNamed)
{
  mapTwoPieces();
  const auto refusal = [&](const std::vector<std::string>& folders)
  {
    const Finished ran = merge(folders, "merged");
    EXPECT_EQ(ran.exit_code, 4) << ran.err;
    EXPECT_FALSE(fs::exists(scratch_ / "merged"));
    return ran.err;
  };
  EXPECT_THAT(refusal({"2"}), HasSubstr("piece 1 of 2 is missing"));
  EXPECT_THAT(refusal({"1"}), HasSubstr("piece 2 of 2 is missing"));
  EXPECT_THAT(refusal({"1", "2", "1"}), HasSubstr("piece 1 is there twice"));
  EXPECT_THAT(refusal({"1", "nowhere"}), HasSubstr("nowhere"));
  fs::copy(scratch_ / "2", scratch_ / "2.partial");
  EXPECT_THAT(refusal({"1", "2.partial"}), HasSubstr("did not end"));
  ASSERT_EQ(map("whole", mrptData(kLaserLog), laserIni()).exit_code, 0);
  EXPECT_THAT(refusal({"1", "whole"}), HasSubstr("--piece"));
  ASSERT_EQ(map("third", mrptData(kLaserLog), laserIni(), {"--piece", "2/3"}).exit_code, 0);
  EXPECT_THAT(refusal({"1", "third"}), HasSubstr("different numbers of pieces"));
}

TEST_F(TraverseMapPieces, OfDifferentLogsPosesAndOptionsAreRefused)
{
  mapTwoPieces();
  writeText(scratch_ / "bend.rawlog", drivenVelodyneLog({0.1, 0.5}));
  ASSERT_EQ(
      map("log", scratch_ / "bend.rawlog", iniOf("robot_pose", "extent = growing\n"),
          {"--piece", "2/2"})
          .exit_code,
      0);
  const Finished logs = merge({"1", "log"}, "merged");
  EXPECT_EQ(logs.exit_code, 4);
  EXPECT_THAT(logs.err, HasSubstr("different logs"));

  const std::string still = iniOf("identity", "extent = growing\n");
  ASSERT_EQ(map("poses", mrptData(kLaserLog), still, {"--piece", "2/2"}).exit_code, 0);
  EXPECT_THAT(merge({"1", "poses"}, "merged").err, HasSubstr("different poses"));

  const auto with = [&](const std::string& folder, const std::string& setting)
  {
    EXPECT_EQ(
        map(folder, mrptData(kLaserLog), laserIni(), {"--piece", "2/2", "--set", setting})
            .exit_code,
        0);
    const Finished ran = merge({"1", folder}, "merged");
    EXPECT_EQ(ran.exit_code, 3) << ran.err;
    return ran.err;
  };
  EXPECT_THAT(with("range", "Sensors.max_range_m=20"), HasSubstr("max_range_m = 20"));
  EXPECT_THAT(with("height", "Vehicle.height_m=1.5"), HasSubstr("height_m = 1.5"));
  EXPECT_THAT(
      with("cells", "Maps_CTraversabilityGridMap_00_insertOpts.cell_size_m=0.4"),
      HasSubstr("other options"));
}

TEST_F(TraverseMapPieces, InterruptedOnesAreRefused)
{
  mapTwoPieces();
  Process process(
      {std::string(TRAVERSE_BINARY_DIR) + "/bin/traverse-map", scratch_ / "2" / "config.ini",
       "--piece", "2/2", "--output", scratch_ / "cut", "--set", "traverse-map.snapshot_every_s=0.2",
       "--set", "traverse-map.pictures=true", "--set", "traverse-map.picture_width_px=200"});
  while (process.running() && !fs::exists(scratch_ / "cut.partial" / "snapshot_0003.png"))
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  process.signal(SIGTERM);
  EXPECT_EQ(process.wait(std::chrono::seconds(60)).exit_code, 143);
  const Finished ran = merge({"1", "cut"}, "merged");
  EXPECT_EQ(ran.exit_code, 4);
  EXPECT_THAT(ran.err, HasSubstr("not mapped to its end"));
}

TEST_F(TraverseMapPieces, DamagedFilesAreRefused)
{
  mapTwoPieces();
  std::mt19937 random(41);
  for (const char* name : {"map.traverse", "metrics.json"})
  {
    const std::string good = readText(scratch_ / "2" / name);
    for (int i = 0; i < 6; ++i)
    {
      std::string bad = good;
      const size_t at = random() % (bad.size() - 2);
      i % 3 == 0 ? bad.resize(at)
                 : void(bad[at] = static_cast<char>(bad[at] ^ (1 << random() % 7)));
      writeText(scratch_ / "2" / name, bad);
      const Finished ran = merge({"1", "2"}, "merged");
      EXPECT_EQ(ran.exit_code, 4) << name << " byte " << at << ran.err;
      EXPECT_THAT(ran.err, HasSubstr(name));
      EXPECT_FALSE(fs::exists(scratch_ / "merged"));
    }
    writeText(scratch_ / "2" / name, good);
  }
  const std::string metrics = readText(scratch_ / "2" / "metrics.json");
  for (const std::string& hostile :
       {std::string(), std::string(2'000'000, '['), std::string("[]"),
        std::string("{\"piece\": 1}"), std::string("{\"piece\": {}, \"crc32\": \"x\"}")})
  {
    writeText(scratch_ / "2" / "metrics.json", hostile);
    EXPECT_EQ(merge({"1", "2"}, "merged").exit_code, 4) << hostile.substr(0, 40);
  }
  writeText(scratch_ / "2" / "metrics.json", metrics);
  fs::remove(scratch_ / "2" / "map.traverse");
  EXPECT_EQ(merge({"1", "2"}, "merged").exit_code, 4);
}

TEST_F(TraverseMapPieces, ThatDoNotFitTogetherAreRefused)
{
  // Places that share no cells: six of them fit in 1 MB, twelve do not.
  std::string log;
  for (int i = 0; i < 12; ++i)
  {
    auto pose = bendPose(i);
    pose.pose.mean = mrpt::poses::CPose3D(20.0 * i, 0, 0, 0, 0, 0);
    log += serialised(pose) + serialised(laserScan(i));
  }
  writeText(scratch_ / "far.rawlog", log);
  const std::string ini_text = iniOf("robot_pose", "extent = growing\nmax_memory_mb = 1\n");
  for (const int k : {1, 2})
  {
    mapPiece(k, 2, scratch_ / "far.rawlog", ini_text);
  }
  const Finished ran = merge({"1", "2"}, "merged");
  EXPECT_EQ(ran.exit_code, 3) << ran.err;
  EXPECT_THAT(ran.err, HasSubstr("has no room in max_memory_mb"));
  EXPECT_FALSE(fs::exists(scratch_ / "merged"));
}

TEST_F(TraverseMapPieces, AFullDiskWhileMergingIsSaid)
{
  mapTwoPieces();
  fs::create_directory(scratch_ / "disk");
  const auto ran = traverseMapOnTinyDisk(
      scratch_ / "disk", 32,
      {"--merge", scratch_ / "1", scratch_ / "2", "--output", scratch_ / "disk" / "merged"});
  if (!ran)
  {
    GTEST_SKIP() << "SKIPPED: no mount namespace here";
  }
  EXPECT_EQ(ran->exit_code, 1);
  EXPECT_THAT(ran->err, HasSubstr("No space left on device"));
}
}  // namespace
