// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/drawn_lidar.h"

#include <gtest/gtest.h>

#include <limits>

using traverse::layers::OccupancyState;
using traverse::multi_lidar_grid::SensorPath;
using traverse::testing::DrawnLidar;
using traverse::testing::DrawnUnitMap;

namespace traverse
{
namespace
{
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr poses::TimeNs kSecond = 1'000'000'000;

/** 20 m/s along x, at x = 0 at second 1. */
poses::PoseTrack driving()
{
  std::vector<poses::StampedPose> poses(3);
  for (int i = 0; i < 3; ++i)
  {
    poses[static_cast<size_t>(i)].time = i * kSecond;
    poses[static_cast<size_t>(i)].T_map_base.translation().x() = 20.0 * (i - 1);
  }
  return poses::PoseTrack(poses);
}

points::ScanBuffer turnOfATenth()
{
  points::ScanBuffer scan = DrawnLidar().turn({});
  scan.stamp = kSecond;
  for (size_t i = 0; i < scan.size(); ++i)
  {
    scan.time_s.push_back(static_cast<float>(i) / static_cast<float>(scan.size() - 1) / 10);
  }
  return scan;
}

TEST(SensorPath, FollowsTheSensorThroughTheTurn)
{
  const points::ScanBuffer scan = turnOfATenth();
  const auto path = SensorPath::along(scan.view(), scan.stamp, driving());
  ASSERT_TRUE(path);
  EXPECT_NEAR(path->originAt(0).x(), 0, 1e-6);  // arithmetic
  EXPECT_NEAR(path->originAt(0.05F).x(), 1, 1e-6);
  EXPECT_NEAR(path->originAt(0.1F).x(), 2, 1e-6);
  EXPECT_NEAR(path->originAt(0.05F).z(), 1.9, 1e-9);
  EXPECT_NEAR(path->originAt(9).x(), 2, 1e-6);
  EXPECT_TRUE(path->originAt(kNan).allFinite());
}

TEST(SensorPath, IsOnePlaceWhereNothingMoves)
{
  const points::ScanBuffer scan = turnOfATenth();
  const auto track = poses::PoseTrack::constant(Eigen::Isometry3d::Identity());
  EXPECT_EQ(SensorPath::along(scan.view(), 0, track)->origins().size(), 1U);
}

TEST(SensorPath, IsNoneWithoutAPose)
{
  const points::ScanBuffer scan = turnOfATenth();
  EXPECT_FALSE(SensorPath::along(scan.view(), 100 * kSecond, driving()));
}

TEST(SensorPath, BeginsAtTheVehicleForScansFromNoOnePlace)
{
  points::ScanBuffer scan = turnOfATenth();
  scan.T_base_sensor.matrix().setConstant(std::numeric_limits<double>::quiet_NaN());
  const auto path = SensorPath::along(scan.view(), scan.stamp, driving());
  ASSERT_TRUE(path);
  EXPECT_NEAR(path->originAt(0).z(), 0, 1e-9);
}

TEST(SensorPath, TimesThatAreNoneCountAsTheStamp)
{
  points::ScanBuffer scan = turnOfATenth();
  for (float& t : scan.time_s)
  {
    t = kNan;
  }
  scan.time_s.front() = 1e30F;
  const auto path = SensorPath::along(scan.view(), scan.stamp, driving());
  ASSERT_TRUE(path);
  EXPECT_NEAR(path->originAt(0).x(), 0, 1e-9);
}

TEST(SensorPath, BeamsAreTracedFromWhereTheyWereSent)
{
  // All beams are sent from 2 m ahead of the stamp's place: their fan opens there.
  points::ScanBuffer scan;
  scan.stamp = kSecond;
  scan.T_base_sensor.translation() = Eigen::Vector3d(0, 0, 1.9);
  const DrawnLidar lidar;
  const points::ScanBuffer turn = lidar.turn({});
  for (size_t i = 0; i < turn.size(); ++i)
  {
    DrawnLidar::add({turn.x[i] + 2.0, turn.y[i], turn.z[i]}, turn.ring[i], scan);
    scan.time_s.push_back(i == 0 ? 0 : 0.1F);
  }
  DrawnUnitMap grid;
  grid.make(scan.view(), driving());
  // The shortest beams land in a circle of 3.3 m, low over the ground from 2.9 m on.
  EXPECT_EQ(grid.stateAt(2, 2), OccupancyState::unknown);
  EXPECT_EQ(grid.stateAt(2, 3.2), OccupancyState::free);
  EXPECT_EQ(grid.stateAt(-1.1, 0.1), OccupancyState::free);
  EXPECT_EQ(grid.stateAt(4.5, 0.1), OccupancyState::unknown);
  EXPECT_EQ(grid.stateAt(5.2, 0.1), OccupancyState::free);
}
}  // namespace
}  // namespace traverse
