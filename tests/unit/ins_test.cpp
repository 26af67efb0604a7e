// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/poses/ins.h>

#include <gtest/gtest.h>

#include <numbers>
#include <support/geodetic_path.h>

namespace
{
using namespace traverse;
using namespace traverse::poses;
using traverse::testing::placeAt;
constexpr TimeNs kStart = 1'600'000'000'000'000'000;
const geometry::Geodetic kHere{40.44, -79.99, 230};
const Eigen::Vector3d kAntenna(-0.3, 0.2, 1.6);

/** A circle of 20 m radius at 5 m/s, counter-clockwise from its south, base on the ground. */
Eigen::Isometry3d onCircle(double t_s)
{
  const double a = 0.25 * t_s;
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = rotationBy(a, Eigen::Vector3d::UnitZ());
  T.translation() << 20 * std::sin(a), 20 - 20 * std::cos(a), 0;
  return T;
}

TimeNs at(double t_s)
{
  return kStart + std::llround(t_s * 1e9);
}

std::vector<GpsFix> fixesOf(Eigen::Isometry3d (*path)(double), int n, bool has_height = true)
{
  std::vector<GpsFix> all;
  all.reserve(static_cast<size_t>(n));
  for (int i = 0; i < n; ++i)
  {
    const Eigen::Vector3d antenna = path(0.1 * i) * kAntenna;
    all.push_back({at(0.1 * i), placeAt(kHere, antenna), has_height, kAntenna});
  }
  return all;
}

PoseParams params()
{
  PoseParams p;
  p.ins_origin = {kHere.latitude_deg, kHere.longitude_deg, kHere.height_m};
  return p;
}

double worst_m(const InsPoses& way, Eigen::Isometry3d (*path)(double))
{
  double worst = 0;
  for (const StampedPose& pose : way.poses)
  {
    const Eigen::Isometry3d truth = path(1e-9 * static_cast<double>(pose.time - kStart));
    worst = std::max(worst, (pose.T_map_base.translation() - truth.translation()).norm());
  }
  return worst;
}

TEST(LocalPlane, UndoesAnIndependentFormula)
{
  for (const geometry::Geodetic& origin :
       {kHere, geometry::Geodetic{-33.9, 151.2, 12}, geometry::Geodetic{78.2, 15.6, 500}})
  {
    const geometry::LocalPlane plane(origin);
    for (const Eigen::Vector3d& p :
         {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1234, -567, 8), Eigen::Vector3d(-2e4, 3e4, 99)})
    {
      // Earth-centred coordinates of 6e6 m have 1e-9 m in a double; a few operations.
      EXPECT_NEAR((plane.at(placeAt(origin, p)) - p).norm(), 0, 2e-8);
    }
  }
}

TEST(Ins, AttitudeAndLeverArmAreRespected)
{
  std::vector<ImuSample> imu;
  imu.reserve(1000);
  for (int i = 0; i < 1000; ++i)
  {
    imu.push_back({at(0.01 * i), onCircle(0.01 * i).linear(), {}});
  }
  const InsPoses way = insPoses(fixesOf(onCircle, 100), imu, params());
  EXPECT_GT(way.poses.size(), 900U);
  EXPECT_EQ(way.fixes_without_heading, 0U);
  // A cubic through fixes 0.1 s apart strays a (0.25 rad/s)^4 20 m 0.1^4 / 384 inside, and by its
  // one-sided speeds at both ends by 0.25^2 20 m 0.1^2 / 8.
  EXPECT_LT(worst_m(way, onCircle), 2e-3);
  EXPECT_NEAR(way.heading_off_course_deg, 0, 1.5) << "the antenna swings out in a bend";
}

TEST(Ins, AnUnknownNorthIsToldFromTheWayDriven)
{
  std::vector<ImuSample> imu;
  imu.reserve(1000);
  for (int i = 0; i < 1000; ++i)
  {
    const Eigen::Matrix3d elsewhere = rotationBy(1.0, Eigen::Vector3d::UnitZ());
    imu.push_back({at(0.01 * i), elsewhere * onCircle(0.01 * i).linear(), {}});
  }
  PoseParams p = params();
  const InsPoses trusting = insPoses(fixesOf(onCircle, 100), imu, p);
  EXPECT_NEAR(trusting.heading_off_course_deg, -180 / std::numbers::pi, 1.5);
  EXPECT_GT(worst_m(trusting, onCircle), 0.3) << "the lever arm points elsewhere";
  p.ins_heading = InsHeading::course;
  // The antenna, 0.3 m behind on a circle of 20 m, moves 0.3 / 20 rad off the vehicle's heading.
  EXPECT_LT(worst_m(insPoses(fixesOf(onCircle, 100), imu, p), onCircle), 0.01);
}

TEST(Ins, CourseAndTurnRateDoWithoutAttitude)
{
  std::vector<ImuSample> gyro;
  gyro.reserve(1000);
  for (int i = 0; i < 1000; ++i)
  {
    gyro.push_back({at(0.01 * i), {}, 0.25 + 0.02});  // with a bias of 1.1 deg/s
  }
  const InsPoses way = insPoses(fixesOf(onCircle, 100), gyro, params());
  EXPECT_GT(way.poses.size(), 900U);
  EXPECT_EQ(way.heading_off_course_deg, 0) << "there is no heading to compare";
  EXPECT_LT(worst_m(way, onCircle), 0.02);
}

TEST(Ins, StandingStillHasNoHeading)
{
  const auto still = [](double) -> Eigen::Isometry3d { return Eigen::Isometry3d::Identity(); };
  const InsPoses way = insPoses(fixesOf(still, 50), {}, params());
  EXPECT_TRUE(way.poses.empty());
  EXPECT_EQ(way.fixes_without_heading, 50U);
  EXPECT_EQ(way.courses, 0U);
}

TEST(Ins, OriginIsTheFirstFixUnlessGiven)
{
  PoseParams p;
  const auto fixes = fixesOf(onCircle, 50);
  const InsPoses way = insPoses(fixes, {}, p);
  ASSERT_TRUE(way.origin.has_value());
  EXPECT_DOUBLE_EQ(way.origin->latitude_deg, fixes.front().place.latitude_deg);
  ASSERT_FALSE(way.poses.empty());
  EXPECT_LT(way.poses.front().T_map_base.translation().norm(), 3);
  EXPECT_FALSE(insPoses({}, {}, p).origin.has_value());
}

TEST(Ins, HeightsAreOfTheReceiversThatTellThem)
{
  auto fixes = fixesOf(onCircle, 50);
  auto flat = fixesOf(onCircle, 50, false);
  for (GpsFix& fix : flat)
  {
    fix.time += 50'000'000;
    fix.place.height_m = 0;
  }
  fixes.insert(fixes.end(), flat.begin(), flat.end());
  for (const StampedPose& pose : insPoses(fixes, {}, params()).poses)
  {
    EXPECT_NEAR(pose.T_map_base.translation().z(), 0, 0.01);
  }
}

TEST(Ins, NoPosesAreMadeUpInAGap)
{
  auto fixes = fixesOf(onCircle, 100);
  fixes.erase(fixes.begin() + 30, fixes.begin() + 60);
  std::vector<ImuSample> imu;
  imu.reserve(1000);
  for (int i = 0; i < 1000; ++i)
  {
    imu.push_back({at(0.01 * i), onCircle(0.01 * i).linear(), {}});
  }
  for (const StampedPose& pose : insPoses(fixes, imu, params()).poses)
  {
    EXPECT_TRUE(pose.time <= at(2.9) || pose.time >= at(6.0));
  }
}

TEST(Ins, StepsFromOneAntennaToAnotherAreNoWay)
{
  // Straight east at 1 m/s: two antennas 2 m apart across, their fixes 0.05 s apart.
  std::vector<GpsFix> fixes;
  for (int i = 0; i < 100; ++i)
  {
    const double t_s = 0.05 * i;
    const Eigen::Vector3d antenna(0, i % 2 == 0 ? 1 : -1, 1);
    fixes.push_back(
        {at(t_s), placeAt(kHere, Eigen::Vector3d(t_s, 0, 0) + antenna), true, antenna,
         static_cast<uint32_t>(i % 2)});
  }
  const InsPoses way = insPoses(fixes, {}, {});
  EXPECT_EQ(way.fixes_of_others, 50U);
  ASSERT_GT(way.poses.size(), 20U);
  for (const StampedPose& pose : way.poses)
  {
    EXPECT_GT(pose.T_map_base.linear()(0, 0), 0.9999) << "it heads east";
  }
}

TEST(Ins, ASlowReceiverHasPosesBetweenItsFixes)
{
  std::vector<GpsFix> fixes;
  std::vector<ImuSample> samples;
  for (int i = 0; i <= 200; ++i)
  {
    const double t_s = 0.1 * i;
    samples.push_back({at(t_s), Eigen::Matrix3d(onCircle(t_s).linear()), std::nullopt});
    if (i % 20 == 0)
    {
      fixes.push_back({at(t_s), placeAt(kHere, onCircle(t_s) * kAntenna), true, kAntenna});
    }
  }
  const InsPoses way = insPoses(fixes, samples, {});
  EXPECT_GT(way.poses.size(), 190U);  // 2 s between fixes, max_pose_age_s is 1
}
}  // namespace
