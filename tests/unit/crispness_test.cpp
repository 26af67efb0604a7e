// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/diagnosis/crispness.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace
{
using namespace traverse;
using namespace traverse::diagnosis;

constexpr double kDegree = std::numbers::pi / 180;

poses::TimeNs ns(double t_s)
{
  return 1'600'000'000'000'000'000 + static_cast<poses::TimeNs>(t_s * 1e9);
}

/** Along x at 6 m/s; `turning`: in bends of up to 30 deg/s. */
Eigen::Isometry3d carAt(double t_s, bool turning)
{
  const double yaw = turning ? 0.5 * std::sin(t_s) : 0.0;
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  T.translation() << 6 * t_s, turning ? 3 * std::sin(0.7 * t_s) : 0.0, 0;
  return T;
}

struct Drive
{
  std::vector<Sighted> scans;
  poses::PoseTrack track;
};

/** Poles and walls beside a road of 20 s, seen ten times a second with 3 cm of noise by a lidar
 * whose stamps are `late_s` too late and that is turned by `heading_rad`. */
Drive drive(bool turning, double late_s, double heading_rad)
{
  std::mt19937 random(9);
  std::uniform_real_distribution<double> any(0, 1);
  std::normal_distribution<double> noise(0, 0.03);
  std::vector<Eigen::Vector3d> things;
  for (int i = 0; i < 900; ++i)
  {
    const double side = any(random) < 0.5 ? -8 : 9;
    const bool pole = any(random) < 0.3;
    const double x = 140 * any(random) - 10;
    things.emplace_back(pole ? std::floor(x / 7) * 7 : x, pole ? side / 2 : side, 2 * any(random));
  }
  const Eigen::AngleAxisd turned(-heading_rad, Eigen::Vector3d::UnitZ());
  Drive drive;
  std::vector<poses::StampedPose> poses;
  for (int i = 0; i < 200; ++i)
  {
    const double t_s = 0.1 * i;
    const Eigen::Isometry3d T_base_map = carAt(t_s, turning).inverse();
    Sighted scan;
    scan.stamp = ns(t_s + late_s);
    for (const Eigen::Vector3d& thing : things)
    {
      const Eigen::Vector3d p = turned * (T_base_map * thing);
      if (p.norm() < 30)
      {
        scan.p_base.emplace_back(
            (p + Eigen::Vector3d(noise(random), noise(random), 0)).cast<float>());
      }
    }
    drive.scans.push_back(std::move(scan));
    poses.push_back({ns(t_s), carAt(t_s, turning)});
  }
  drive.track = poses::PoseTrack(poses);
  return drive;
}

TEST(Crispness, TellsAClockThatIsOff)
{
  const Drive d = drive(true, 0.12, 0);
  const auto fit = Crispness(d.scans, d.track).timeOffset();
  ASSERT_TRUE(fit);
  EXPECT_TRUE(fit->differs());
  EXPECT_NEAR(fit->value, -0.12, 0.015);  // a step of the search is 5 ms
}

TEST(Crispness, FindsNoFaultWhereThereIsNone)
{
  const Drive d = drive(true, 0, 0);
  const Crispness crispness(d.scans, d.track);
  EXPECT_TRUE(crispness.timeOffset()->canTell());
  EXPECT_FALSE(crispness.timeOffset()->differs());
  EXPECT_TRUE(crispness.heading()->canTell());
  EXPECT_FALSE(crispness.heading()->differs());
}

TEST(Crispness, CannotTellTimeFromAStraightDriveAtOneSpeed)
{
  const Drive d = drive(false, 0.12, 0);
  EXPECT_FALSE(Crispness(d.scans, d.track).timeOffset()->canTell());
}

TEST(Crispness, TellsASensorThatIsTurned)
{
  for (const double deg : {-90.0, 4.0})
  {
    const Drive d = drive(false, 0, deg * kDegree);
    const auto fit = Crispness(d.scans, d.track).heading();
    ASSERT_TRUE(fit);
    EXPECT_TRUE(fit->differs()) << deg;
    EXPECT_NEAR(fit->value, deg, 0.5);  // 0.3 m aside at 30 m, about a cell
  }
}

TEST(Crispness, NeedsTenScansWithPoses)
{
  Drive d = drive(true, 0, 0);
  d.scans.resize(9);
  EXPECT_FALSE(Crispness(d.scans, d.track).timeOffset());
  EXPECT_FALSE(Crispness(drive(true, 0, 0).scans, poses::PoseTrack()).heading());
}
}  // namespace
