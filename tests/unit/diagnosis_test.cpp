// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/diagnosis/ground_plane.h>
#include <traverse/diagnosis/travel.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace
{
using namespace traverse;
using namespace traverse::diagnosis;
constexpr double kDegree = std::numbers::pi / 180;
constexpr poses::TimeNs kMs = 1'000'000;

TEST(Travel, TellsWhichAxisGoesAhead)
{
  std::vector<poses::StampedPose> poses(21);
  for (int i = 0; i <= 20; ++i)
  {
    auto& pose = poses[static_cast<size_t>(i)];
    pose.time = 1'000'000'000'000'000'000 + i * 100 * kMs;
    pose.T_map_base.linear() = Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    // 5 m/s along its own y, and one stop of a second on the way
    pose.T_map_base.translation() =
        pose.T_map_base.linear() * Eigen::Vector3d(0, 0.5 * (i < 10 ? i : std::max(10, i - 10)), 0);
  }
  const Travel travel = travelOf(poses::PoseTrack(poses));
  EXPECT_NEAR(travel.distance_m, 5, 1e-9);
  EXPECT_NEAR(travel.heading_deg, 90, 1e-6);
  EXPECT_NEAR(travel.share, 1, 1e-9);
  EXPECT_NEAR(travel.top_speed_mps, 5, 1e-6);
  EXPECT_EQ(travelOf(poses::PoseTrack()).distance_m, 0);
}

void add(points::ScanBuffer& scan, const Eigen::Vector3d& p)
{
  scan.x.push_back(static_cast<float>(p.x()));
  scan.y.push_back(static_cast<float>(p.y()));
  scan.z.push_back(static_cast<float>(p.z()));
}

/** A street as a sensor 1.7 m up sees it: ground with 2 cm of noise all around, a wall at the left
 * that has as many points, things that stand about. Turned by `T`. */
points::ScanBuffer street(const Eigen::Isometry3d& T)
{
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0, 0.02);
  std::uniform_real_distribution<double> any(0, 1);
  points::ScanBuffer scan;
  for (int i = 0; i < 3000; ++i)
  {
    const double range_m = 3 + 20 * any(random);
    const double around = 2 * std::numbers::pi * any(random);
    const Eigen::Vector3d on_ground(
        range_m * std::cos(around), range_m * std::sin(around), -1.7 + noise(random));
    if (on_ground.y() < 6)
    {
      add(scan, T * on_ground);
    }
    add(scan, T * Eigen::Vector3d(40 * any(random) - 20, 6 + noise(random), 4 * any(random) - 1.7));
    if (i % 3 == 0)
    {
      add(scan, T * Eigen::Vector3d(8, -5 - any(random), 2 * any(random) - 1.7));
    }
  }
  return scan;
}

TEST(GroundPlane, IsFoundWithItsHeightAndLean)
{
  // The sensor is pitched up by 3 degrees: in its frame the ground ahead lies lower.
  const Eigen::Isometry3d T(Eigen::AngleAxisd(3 * kDegree, Eigen::Vector3d::UnitY()));
  const auto ground = findGround(street(T).view(), GroundSearch::level);
  ASSERT_TRUE(ground);
  EXPECT_NEAR(ground->sensor_m, 1.7, 0.01);  // 2 cm of noise over a thousand points
  EXPECT_NEAR(ground->offset_m, -1.7, 0.01);
  EXPECT_NEAR(ground->pitch_deg(), 3, 0.1);
  EXPECT_NEAR(ground->roll_deg(), 0, 0.1);
  EXPECT_NEAR(ground->rms_m, 0.025, 0.008);  // and what stands on it, up to 0.1 m
}

TEST(GroundPlane, IsFoundWhereAxesAreSwapped)
{
  // Camera axes: x right, y down, z forward.
  Eigen::Isometry3d T_camera_base = Eigen::Isometry3d::Identity();
  T_camera_base.linear() << 0, -1, 0, 0, 0, -1, 1, 0, 0;
  const points::ScanBuffer scan = street(T_camera_base);
  EXPECT_FALSE(findGround(scan.view(), GroundSearch::level));
  const auto ground = findGround(scan.view(), GroundSearch::any_around);
  ASSERT_TRUE(ground);
  EXPECT_LT((ground->up + Eigen::Vector3d::UnitY()).norm(), 0.01);
  EXPECT_NEAR(ground->sensor_m, 1.7, 0.01);
}

TEST(GroundPlane, IsNoneWhereThereIsOnlyAWall)
{
  points::ScanBuffer scan;
  std::mt19937 random(6);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int i = 0; i < 2000; ++i)
  {
    add(scan, {10 * any(random), 5, 2 * any(random)});
  }
  EXPECT_FALSE(findGround(scan.view(), GroundSearch::level));
  EXPECT_FALSE(findGround(scan.view(), GroundSearch::any_around));
  EXPECT_FALSE(findGround(points::ScanBuffer().view(), GroundSearch::level));
}

TEST(GroundPlane, OfSeveralScansIsTheirMedian)
{
  std::vector<GroundPlane> planes(5);
  for (int i = 0; i < 5; ++i)
  {
    planes[static_cast<size_t>(i)].offset_m = -1.7 - 0.01 * i;
  }
  planes[4].offset_m = 12;  // a bridge that one of them drove under
  const auto seen = agree(planes);
  ASSERT_TRUE(seen);
  EXPECT_DOUBLE_EQ(seen->offset_m, -1.71);
  EXPECT_EQ(seen->scans, 5U);
  EXPECT_FALSE(agree({}));
}
}  // namespace
