// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// What the navigator would have commanded a wheelchair that recorded a real drive (Debian's
// mrpt-common).
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <support/traverse_nav.h>
#include <vector>

namespace
{
using namespace traverse;
namespace fs = std::filesystem;

const fs::path recorded =
    "/usr/share/mrpt/datasets/2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog";

class Replay : public traverse::testing::NavRun
{
 protected:
  app::ExitCode replay(const fs::path& log, const std::vector<std::string>& more = {}) const
  {
    const fs::path ini = fs::path(TRAVERSE_SOURCE_DIR) / "ini" / "nav_replay_laser2d.ini";
    std::vector<std::string> args = {
        ini.string(), "--replay", log.string(), "--output", path("out")};
    args.insert(args.end(), more.begin(), more.end());
    return run(args);
  }
};

TEST_F(Replay, WouldHaveDrivenAlmostAlwaysWhereTheVehicleDrove)
{
  ASSERT_EQ(replay(recorded), app::ExitCode::done);
  const auto metrics = nlohmann::json::parse(bytes("out/metrics.json"));
  EXPECT_EQ(metrics["scans"], 225) << "as many as traverse-map has of this log";
  EXPECT_EQ(metrics["scans_without_pose"], 0);
  EXPECT_NEAR(metrics["way_m"].get<double>(), 76, 4);
  EXPECT_GT(metrics["conduct"]["drive"], 0.9);
  // nobody drove through a wall, so neither must the maps say so
  EXPECT_EQ(metrics["driven_into_obstacles"], 0);
  EXPECT_GT(metrics["both_move"]["share"], 0.6);
  EXPECT_LE(metrics["both_move"]["commanded_mean_mps"], 1.0);  // [Drivetrain]
  EXPECT_NE(bytes("out/report.html").find("A replay of a recorded log"), std::string::npos);
  EXPECT_NE(bytes("out/decisions.csv").find("\n0.000,"), std::string::npos)
      << "times count from the log's first scan";
}

TEST_F(Replay, SavesWhatCameBeforeADamage)
{
  std::ifstream whole(recorded, std::ios::binary);
  std::string half(fs::file_size(recorded) / 2, '\0');
  whole.read(half.data(), static_cast<std::streamsize>(half.size()));
  write("cut.rawlog", half);
  ASSERT_EQ(replay(path("cut.rawlog")), app::ExitCode::partial);
  const auto metrics = nlohmann::json::parse(bytes("out/metrics.json"));
  EXPECT_NE(metrics["problem"].get<std::string>().find("cut.rawlog"), std::string::npos);
  EXPECT_GT(metrics["scans"], 50);
  EXPECT_LT(metrics["scans"], 225);
}

TEST_F(Replay, RefusesWhatIsNoLogAndWhatDoesNotMove)
{
  EXPECT_EQ(replay(path("missing.rawlog")), app::ExitCode::unreadable);
  write("text.rawlog", "no log");
  EXPECT_EQ(replay(path("text.rawlog")), app::ExitCode::unreadable);
  EXPECT_EQ(replay(recorded, {"--set", "Poses.source=identity"}), app::ExitCode::configuration);
  EXPECT_FALSE(fs::exists(path("out")));
}

TEST_F(Replay, GoesToTheGoalsOfTheIni)
{
  ASSERT_EQ(
      replay(
          recorded, {"--set", "traverse-nav.goal_xs_m=3", "--set", "traverse-nav.goal_ys_m=0",
                     "--set", "traverse-nav.max_time_s=8"}),
      app::ExitCode::done);
  const auto metrics = nlohmann::json::parse(bytes("out/metrics.json"));
  EXPECT_EQ(metrics["end"], "max_time_s");
  EXPECT_NEAR(metrics["time_s"].get<double>(), 8, 0.2);
}
}  // namespace
