// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// A car whose wheels take their time follows paths of arcs.
#include <traverse/navigation/motion.h>
#include <traverse/navigation/on_path.h>
#include <traverse/navigation/speed_profile.h>
#include <traverse/navigation/track_path.h>
#include <traverse/simulation/vehicle_model.h>

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <support/costmap_pictures.h>
#include <support/simple_scene.h>
#include <vector>

namespace
{
using namespace traverse;
using navigation::Motion;
using navigation::Path;

const geometry::Pose2 at_start = {20, 20, 0};

geometry::Drivetrain car()
{
  geometry::Drivetrain drivetrain;
  drivetrain.steering = geometry::Steering::ackermann;
  drivetrain.wheelbase_m = 1;
  drivetrain.max_steer_deg = 35;
  drivetrain.max_steer_rate_degps = 60;
  drivetrain.max_speed_mps = 2;
  drivetrain.max_reverse_mps = 0.7;
  return drivetrain;
}

/** From the middle of the costmap along the x axis. */
Path pathOf(const std::vector<Motion>& motions)
{
  Path path;
  navigation::Posed at = navigation::posed(at_start);
  for (const Motion& motion : motions)
  {
    navigation::drive(path, at, motion);
    at = navigation::after(at, navigation::shiftOf(motion));
  }
  return path;
}

/** The largest distance from the path (one piece) on the way along it, and the last pose. */
struct Drive
{
  double off_m = 0;
  double turned_rad = 0;  //!< at the end, against the path
  bool ends = false;
};

Drive follow(const Path& path, const geometry::Pose2& start)
{
  const geometry::Drivetrain drivetrain = car();
  simulation::VehicleModel model(
      std::make_shared<traverse::testing::PlaneTerrain>(0, 0, 0), {}, drivetrain, start);
  const auto limits =
      navigation::speedProfile(path, traverse::testing::openCostmap(40, 1000), drivetrain, 0, {});
  Drive result;
  for (int step = 0; step < 1200 && !result.ends; ++step)
  {
    const geometry::Pose2 pose = model.state().pose;
    const auto here = navigation::nearestOn(path, {pose.x_m, pose.y_m});
    const double speed_mps = std::max(0.15, limits[here.next].speed_mps);
    const auto command = navigation::trackPath(path, pose, speed_mps, drivetrain);
    if (!command)
    {
      ADD_FAILURE() << "lost the path after " << here.along_m << " m";
      break;
    }
    model.step(*command, 0.05);
    result.off_m = std::max(result.off_m, here.off_m);
    result.ends = path.back().along_m - here.along_m < 0.05;
    result.turned_rad =
        std::remainder(pose.yaw_rad - path.back().pose.yaw_rad, 2 * std::numbers::pi);
  }
  return result;
}

constexpr double kTight = 0.65;  // a little wider than its steering's most

TEST(TrackPath, ArcsOfBothHandsAreFollowedClosely)
{
  const Path path = pathOf({{0, 2}, {kTight, 2.4}, {-kTight, 2.4}, {0, 1}, {-kTight, 3}, {0, 2}});
  const Drive drive = follow(path, at_start);
  EXPECT_TRUE(drive.ends);
  EXPECT_LT(drive.off_m, 0.08);
  EXPECT_NEAR(drive.turned_rad, 0, 0.1);
}

TEST(TrackPath, SoAreArcsBackward)
{
  const Drive drive = follow(pathOf({{0, -1}, {kTight, -2.4}, {-kTight, -2.4}, {0, -1}}), at_start);
  EXPECT_TRUE(drive.ends);
  EXPECT_LT(drive.off_m, 0.08);
  EXPECT_NEAR(drive.turned_rad, 0, 0.1);
}

TEST(TrackPath, LeadsBackToThePath)
{
  for (const double length_m : {8.0, -8.0})
  {
    const Drive drive = follow(pathOf({{0, length_m}}), {20, 20.4, 0.3});
    EXPECT_TRUE(drive.ends);
    EXPECT_LT(drive.off_m, 0.6) << "it begins 0.4 m off, looking away or back";
    EXPECT_NEAR(drive.turned_rad, 0, 0.03);
  }
}

TEST(TrackPath, NothingLeadsFromFarOffOrAcross)
{
  const Path path = pathOf({{0, 5}});
  EXPECT_TRUE(navigation::trackPath(path, {21, 20.5, 0}, 1, car()));
  EXPECT_FALSE(navigation::trackPath(path, {21, 20.7, 0}, 1, car()));
  EXPECT_FALSE(navigation::trackPath(path, {21, 20, 1.2}, 1, car()));
  EXPECT_FALSE(navigation::trackPath(path, {NAN, 0, 0}, 1, car()));
  EXPECT_FALSE(navigation::trackPath({}, {0, 0, 0}, 1, car()));
}

TEST(TrackPath, TurnsNoTighterThanTheCar)
{
  const Path path = pathOf({{0, 5}});
  const auto command = navigation::trackPath(path, {21, 20.55, 0.9}, 1, car());
  ASSERT_TRUE(command);
  EXPECT_NEAR(command->yaw_rate_radps, -std::tan(35 * std::numbers::pi / 180), 1e-9);
}
}  // namespace
