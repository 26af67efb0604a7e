// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// The closed loop: a small robot with one lidar in a yard of 16 x 12 m, as a program would run it.
#include <traverse/nav_app/closed_loop.h>

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <support/traverse_nav.h>
#include <vector>

namespace
{
using namespace traverse;

/** Things within a fence. */
std::string scene(const std::string& things)
{
  return "[Scene]\nmin_x_m = -8\nmax_x_m = 8\nmin_y_m = -6\nmax_y_m = 6\n"
         "[Object_00]\nkind = wall\nx_m = 0\ny_m = 0\nxs_m = -7 7 7 -7 -7\nys_m = -5 -5 5 5 -5\n" +
         things + "[Mission]\nstart_x_m = -5\ngoal_xs_m = 5\ngoal_ys_m = 0\n";
}

const std::string box_on_the_way =
    "[Object_01]\nkind = box\nx_m = 0\ny_m = 0.5\nlength_m = 1\nwidth_m = 3\nheight_m = 1.2\n";

std::string board(int number, double x_m, double y_m, int yaw_deg)
{
  return "[Object_0" + std::to_string(number) + "]\nkind = box\nx_m = " + std::to_string(x_m) +
         "\ny_m = " + std::to_string(y_m) + "\nyaw_deg = " + std::to_string(yaw_deg) +
         "\nlength_m = 3.2\nwidth_m = 0.2\nheight_m = 1.2\n";
}

/** Four boards around the goal. */
std::string boardedGoal()
{
  return board(1, 5, 1.5, 0) + board(2, 5, -1.5, 0) + board(3, 3.5, 0, 90) + board(4, 6.5, 0, 90);
}

const std::string robot =
    "[traverse-nav]\nscene = scene.ini\nmax_time_s = 40\ncontrol_hz = 10\n"
    "[Vehicle]\nfootprint_xs_m = -0.3 0.3 0.3 -0.3\nfootprint_ys_m = -0.25 -0.25 0.25 0.25\n"
    "height_m = 1\n"
    "[Drivetrain]\nmax_speed_mps = 1.5\n"
    "[Lidar_00]\nmodel = VLP-16\nz_m = 0.6\n"
    "[Costmap]\nwindow_m = 24\nsoft_buffer_m = 0.4\n"
    "[Reactive]\nreference_distance_m = 3\npaths = 31\ngrid_resolution_m = 0.1\n"
    "[Maps]\nCWrappableMultiLidarGrid_count = 1\n"
    "[Maps_CWrappableMultiLidarGrid_00_insertOpts]\nwindow_m = 24\nmax_range_m = 20\n";

class TraverseNav : public traverse::testing::NavRun
{
 protected:
  app::ExitCode navigate(const std::vector<std::string>& more = {}) const
  {
    std::vector<std::string> args = {path("robot.ini"), "--seed", "3"};
    args.insert(args.end(), more.begin(), more.end());
    return run(args);
  }
};

TEST_F(TraverseNav, DrivesRoundABoxToItsGoalAndTheSameSeedDrivesTheSame)
{
  write("scene.ini", scene(box_on_the_way));
  write("robot.ini", robot);
  ASSERT_EQ(navigate({"--output", path("a")}), app::ExitCode::done);
  const auto metrics = nlohmann::json::parse(bytes("a/metrics.json"));
  EXPECT_TRUE(metrics["reached"]) << metrics["end"];
  EXPECT_EQ(metrics["collisions"], 0);
  EXPECT_GT(metrics["min_clearance_m"], 0.1);
  EXPECT_GT(metrics["way_m"], 10.0);  // round the box, not through it
  EXPECT_LT(metrics["time_over_optimum"], 4.0);
  EXPECT_NE(bytes("a/report.html").find("What held the speed down"), std::string::npos);
  EXPECT_FALSE(bytes("a/CWrappableMultiLidarGrid.traverse").empty());
  ASSERT_EQ(navigate({"--output", path("b")}), app::ExitCode::done);
  EXPECT_EQ(bytes("a/drive.csv"), bytes("b/drive.csv"));
  EXPECT_EQ(
      bytes("a/CWrappableMultiLidarGrid.traverse"), bytes("b/CWrappableMultiLidarGrid.traverse"));
}

TEST_F(TraverseNav, StandsAndSaysSoWithinThreeSecondsWhereThereIsNoWay)
{
  write("scene.ini", scene(boardedGoal()));
  write("robot.ini", robot);
  ASSERT_EQ(navigate({"--output", path("a")}), app::ExitCode::done);
  const auto metrics = nlohmann::json::parse(bytes("a/metrics.json"));
  EXPECT_FALSE(metrics["reached"]);
  EXPECT_EQ(metrics["collisions"], 0);
  EXPECT_NE(metrics["end"].get<std::string>().find("no way"), std::string::npos) << metrics["end"];
  EXPECT_LT(metrics["time_s"], 38);  // it gave up by itself
  // the last stop was stated when the way was lost, no_way_s before the end
  const std::string decisions = bytes("a/decisions.csv");
  EXPECT_NE(decisions.find("give_up,no_way"), std::string::npos) << decisions;
}

TEST_F(TraverseNav, RefusesWhatItCannotUse)
{
  write("scene.ini", scene(""));
  write("robot.ini", robot + "[Costmap2]\nx = 1\n");
  EXPECT_EQ(navigate({"--output", path("a")}), app::ExitCode::configuration);
  write("robot.ini", robot + "[Guard]\nmargin = 1\n");
  EXPECT_EQ(navigate({"--output", path("a")}), app::ExitCode::configuration);
  write("robot.ini", robot);
  EXPECT_EQ(navigate({}), app::ExitCode::usage);
  EXPECT_EQ(navigate({"--output", path("a"), "--why", "here"}), app::ExitCode::usage);
  write("scene.ini", "[Scene]\nmin_x_m = -8\nmax_x_m = 8\nmin_y_m = -6\nmax_y_m = 6\n");
  EXPECT_EQ(navigate({"--check-config"}), app::ExitCode::configuration);  // no mission
  EXPECT_FALSE(std::filesystem::exists(path("a")));
}
}  // namespace
