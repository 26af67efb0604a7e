// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/evaluation/rand_index.h>
#include <traverse/evaluation/trajectory_errors.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace
{
using namespace traverse;
using namespace traverse::evaluation;
using poses::StampedPose;

constexpr double kDeg = 3.14159265358979323846 / 180;
constexpr int64_t kSecond = 1'000'000'000;

Eigen::Isometry3d pose(double x, double y, double yaw_rad = 0)
{
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = poses::rotationBy(yaw_rad, Eigen::Vector3d::UnitZ());
  T.translation() = Eigen::Vector3d(x, y, 0);
  return T;
}

/** 1 m/s along x, then along y, one pose a second. */
std::vector<StampedPose> corner(int n)
{
  std::vector<StampedPose> path;
  for (int i = 0; i < n; ++i)
  {
    const int half = n / 2;
    path.push_back({i * kSecond, i < half ? pose(i, 0) : pose(half, i - half, 90 * kDeg)});
  }
  return path;
}

TEST(TrajectoryErrors, SamePathHasNone)
{
  const PosePairs p = associate(corner(20), corner(20));
  EXPECT_EQ(p.pairs.size(), 20U);
  EXPECT_EQ(p.without_truth, 0U);
  const AbsoluteError e = absoluteError(p.pairs);
  EXPECT_NEAR(e.rmse_m, 0, 1e-12);
  EXPECT_NEAR(e.from_start_m, 0, 1e-12);
  EXPECT_NEAR(stepError(p.pairs).translation_percent, 0, 1e-9);
}

TEST(TrajectoryErrors, ARigidMotionIsAlignedAway)
{
  std::vector<StampedPose> moved = corner(20);
  for (StampedPose& p : moved)
  {
    p.T_map_base = pose(5, -3, 0.7) * p.T_map_base;
  }
  const PosePairs p = associate(moved, corner(20));
  const AbsoluteError e = absoluteError(p.pairs);
  EXPECT_NEAR(e.rmse_m, 0, 1e-9);
  EXPECT_NEAR(e.max_m, 0, 1e-9);
  EXPECT_NEAR(e.from_start_m, 0, 1e-9);
  EXPECT_GT(e.as_they_are_m, 1);
}

TEST(TrajectoryErrors, ScaleIsNotAlignedAway)
{
  std::vector<StampedPose> longer;
  std::vector<StampedPose> truth;
  for (int i = 0; i < 11; ++i)
  {
    longer.push_back({i * kSecond, pose(1.1 * i, 0)});
    truth.push_back({i * kSecond, pose(i, 0)});
  }
  const PosePairs p = associate(longer, truth);
  const AbsoluteError e = absoluteError(p.pairs);
  // 0.1 i - 0.5: the root of the mean of squares of -0.5 ... 0.5 in steps of 0.1
  EXPECT_NEAR(e.rmse_m, std::sqrt(0.1), 1e-9);
  EXPECT_NEAR(e.max_m, 0.5, 1e-9);
  const auto r = relativeErrors(p.pairs, {2, 5, 100, 0});
  EXPECT_NEAR(r[0].translation_percent, 10, 1e-9);
  EXPECT_EQ(r[0].pieces, 9U);
  EXPECT_NEAR(r[1].translation_percent, 10, 1e-9);
  EXPECT_NEAR(r[1].rotation_deg_per_m, 0, 1e-12);
  EXPECT_EQ(r[2].pieces, 0U);
  EXPECT_TRUE(std::isnan(r[2].translation_percent));
  EXPECT_TRUE(std::isnan(r[3].rotation_deg_per_m));
}

TEST(TrajectoryErrors, TurnsAreCountedPerMetre)
{
  std::vector<StampedPose> turning;
  std::vector<StampedPose> truth;
  for (int i = 0; i < 5; ++i)
  {
    turning.push_back({i * kSecond, pose(i, 0, 2 * kDeg * i)});
    truth.push_back({i * kSecond, pose(i, 0)});
  }
  const PosePairs p = associate(turning, truth);
  EXPECT_NEAR(relativeErrors(p.pairs, {1})[0].rotation_deg_per_m, 2, 1e-9);
  EXPECT_NEAR(stepError(p.pairs).rotation_deg_per_m, 2, 1e-9);
}

TEST(TrajectoryErrors, TruthIsInterpolatedAndNotContinued)
{
  const std::vector<StampedPose> truth = {{0, pose(0, 0)}, {kSecond, pose(1, 0)}};
  const std::vector<StampedPose> found = {
      {kSecond / 4, pose(0.25, 0)}, {-kSecond / 2, pose(0, 0)}, {2 * kSecond, pose(2, 0)}};
  const PosePairs p = associate(found, truth);
  ASSERT_EQ(p.pairs.size(), 1U);
  EXPECT_NEAR(p.pairs[0].truth.translation().x(), 0.25, 1e-12);
  EXPECT_EQ(p.without_truth, 2U);
}

TEST(TrajectoryErrors, NothingInCommonIsNaN)
{
  StampedPose broken;
  broken.T_map_base.translation().x() = std::numeric_limits<double>::quiet_NaN();
  const PosePairs p = associate({broken}, corner(5));
  EXPECT_TRUE(p.pairs.empty());
  EXPECT_TRUE(std::isnan(absoluteError(p.pairs).rmse_m));
  EXPECT_TRUE(std::isnan(stepError(p.pairs).translation_percent));
  EXPECT_TRUE(std::isnan(relativeErrors(p.pairs, {1})[0].translation_percent));
  EXPECT_TRUE(associate({}, {}).pairs.empty());
}

TEST(TrajectoryErrors, StandingStillHasNoRelativeError)
{
  const std::vector<StampedPose> still = {{0, pose(1, 1)}, {kSecond, pose(1, 1)}};
  const PosePairs p = associate(still, still);
  EXPECT_NEAR(absoluteError(p.pairs).rmse_m, 0, 1e-12);
  EXPECT_TRUE(std::isnan(stepError(p.pairs).translation_percent));
  EXPECT_EQ(relativeErrors(p.pairs, {1})[0].pieces, 0U);
}

using Labels = std::vector<uint32_t>;

TEST(RandIndex, IsOneForTheSameGroupsOfOtherNames)
{
  EXPECT_DOUBLE_EQ(adjustedRandIndex(Labels{1, 1, 2, 2, 3}, Labels{7, 7, 5, 5, 0}), 1);
}

TEST(RandIndex, IsThatByHand)
{
  // pairs: 2 within a, 3 within b (of 6), 1 within both; by chance 2 * 3 / 6 = 1
  EXPECT_DOUBLE_EQ(adjustedRandIndex(Labels{0, 0, 1, 1}, Labels{0, 0, 0, 1}), 0);
  // 2 and 2 within, none within both; by chance 4 / 6
  EXPECT_DOUBLE_EQ(adjustedRandIndex(Labels{0, 0, 1, 1}, Labels{0, 1, 0, 1}), -0.5);
}

TEST(RandIndex, OfDegenerateLabelingsIsDefined)
{
  EXPECT_DOUBLE_EQ(adjustedRandIndex(Labels{1, 1, 1}, Labels{4, 4, 4}), 1);
  EXPECT_DOUBLE_EQ(adjustedRandIndex(Labels{1, 2, 3}, Labels{3, 2, 1}), 1);
  EXPECT_DOUBLE_EQ(adjustedRandIndex(Labels{1, 1, 1}, Labels{1, 2, 3}), 0);
  EXPECT_TRUE(std::isnan(adjustedRandIndex(Labels{}, Labels{})));
  EXPECT_TRUE(std::isnan(adjustedRandIndex(Labels{1}, Labels{1})));
  EXPECT_THROW(adjustedRandIndex(Labels{1}, Labels{}), std::invalid_argument);
}
}  // namespace
