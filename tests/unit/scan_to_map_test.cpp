// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/registration/scan_to_map.h>

#include <gtest/gtest.h>

#include <support/analytic_street.h>

namespace
{
using namespace traverse;
using namespace traverse::testing;
using registration::Matched;
using registration::ScanToMap;
using registration::Verdict;
constexpr poses::TimeNs kStart = 1'600'000'000'000'000'000;
constexpr double kDegPerRad = 180 / std::numbers::pi;

Eigen::Isometry3d place(double x, double y, double yaw)
{
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  T.translation() << x, y, 0;
  return T;
}

/** 8 m/s, swinging from side to side. */
Eigen::Isometry3d onStreet(double t_s)
{
  return place(8 * t_s, 1.5 * std::sin(0.8 * t_s), 0.15 * std::sin(0.8 * t_s));
}

Eigen::Isometry3d inRoom(double t_s)
{
  return place(0.5 * t_s - 1, 0.3 * std::sin(t_s), 0.6 * std::sin(t_s));
}

struct Drive
{
  AnalyticWorld world;
  SpinningLidar lidar;
  SpinningLidar::Path path;
  int scans = 20;
  bool times = true;  //!< points have times
};

/** How far off the last pose is. */
struct Off
{
  int tracked = 0;
  double worst_m = 0;
  double worst_deg = 0;
  std::vector<Verdict> verdicts;
};

Off follow(const Drive& drive)
{
  ScanToMap way({});
  Off off;
  const Eigen::Isometry3d T_first_map = drive.path(0.5).inverse();
  for (int i = 0; i < drive.scans; ++i)
  {
    const double t_s = 0.5 + 0.1 * i;
    points::ScanBuffer scan = drive.lidar.scan(drive.world, drive.path, t_s, kStart);
    if (!drive.times)
    {
      scan.time_s.clear();
    }
    const Matched matched = way.take(std::move(scan));
    off.verdicts.push_back(matched.verdict);
    if (matched.verdict == Verdict::tracked)
    {
      const Eigen::Isometry3d E = (T_first_map * drive.path(t_s)).inverse() * matched.T_map_base;
      ++off.tracked;
      off.worst_m = std::max(off.worst_m, E.translation().norm());
      off.worst_deg = std::max(off.worst_deg, Eigen::AngleAxisd(E.linear()).angle() * kDegPerRad);
    }
  }
  return off;
}

SpinningLidar lidar(int rings)
{
  SpinningLidar l;
  l.rings = rings;
  l.lowest_deg = rings == 16 ? -15 : -25;
  l.noise_m = 0.02;
  return l;
}

TEST(ScanToMap, KeepsItsPlaceInARoom)
{
  Drive drive{room(), lidar(16), inRoom};
  drive.lidar.height_m = 0.6;
  const Off off = follow(drive);
  EXPECT_EQ(off.tracked, 19) << "the first scan waits for the second";
  EXPECT_EQ(off.verdicts.front(), Verdict::waiting);
  // Ranges have 2 cm of noise, a thousand pairs; what is left is drift along 1 m of way.
  EXPECT_LT(off.worst_m, 0.02);
  EXPECT_LT(off.worst_deg, 0.4);
}

TEST(ScanToMap, FollowsAStreet)
{
  const Off off = follow({street(), lidar(32), onStreet});
  EXPECT_EQ(off.tracked, 19);
  // 15 m of way: 0.3 percent.
  EXPECT_LT(off.worst_m, 0.05);
  EXPECT_LT(off.worst_deg, 0.2);
}

TEST(ScanToMap, DeskewsItsOwnFastTurn)
{
  Drive drive{
      street(), lidar(32), [](double t_s) { return place(10 + 2 * t_s, 0, 2.0 * t_s); }, 12};
  const Off with = follow(drive);
  drive.times = false;
  const Off without = follow(drive);
  EXPECT_EQ(with.tracked, 11);
  EXPECT_LT(with.worst_m, 0.1);
  EXPECT_TRUE(without.tracked < with.tracked || without.worst_deg > 3 * with.worst_deg)
      << without.tracked << ", " << without.worst_deg << " deg against " << with.worst_deg;
}

TEST(ScanToMap, MakesUpNoWayAlongAnEndlessCorridor)
{
  const auto path = [](double t_s) { return place(t_s, 0.1 * std::sin(t_s), 0); };
  const Off off = follow({corridor(), lidar(16), path, 10});
  EXPECT_EQ(off.tracked, 0);
  EXPECT_EQ(off.verdicts.back(), Verdict::featureless);
}

TEST(ScanToMap, StandsStill)
{
  const Off off = follow({street(), lidar(32), [](double) { return place(20, 0, 0.2); }, 15});
  EXPECT_EQ(off.tracked, 14);
  // Noise of 2 cm a range over about a thousand pairs.
  EXPECT_LT(off.worst_m, 0.02);
}

TEST(ScanToMap, TakesNoPoseFromNothing)
{
  ScanToMap way({});
  points::ScanBuffer empty;
  EXPECT_EQ(way.take(empty).verdict, Verdict::too_few_points);
  points::ScanBuffer one_spot = empty;
  for (int i = 0; i < 5000; ++i)
  {
    one_spot.x.push_back(3);
    one_spot.y.push_back(i % 7 == 0 ? NAN : 0);
    one_spot.z.push_back(i % 11 == 0 ? INFINITY : 1e30F);
  }
  EXPECT_EQ(way.take(one_spot).verdict, Verdict::too_few_points);
  const points::ScanBuffer good = lidar(32).scan(street(), onStreet, 0.5, kStart);
  EXPECT_EQ(way.take(good).verdict, Verdict::waiting);
  points::ScanBuffer next = lidar(32).scan(street(), onStreet, 0.6, kStart);
  EXPECT_EQ(way.take(next).verdict, Verdict::tracked);
  EXPECT_EQ(way.take(empty).verdict, Verdict::too_few_points);
}

TEST(ScanToMap, CallsAnotherPlaceNoMatch)
{
  ScanToMap way({});
  for (const double t_s : {0.5, 0.6, 0.7})
  {
    way.take(lidar(32).scan(street(), onStreet, t_s, kStart));
  }
  const auto elsewhere = [](double) { return place(-1, 0.5, 0.3); };
  points::ScanBuffer scan = lidar(32).scan(room(), elsewhere, 0.8, kStart);
  EXPECT_NE(way.take(std::move(scan)).verdict, Verdict::tracked);
}

TEST(ScanToMap, RefusesLengthsThatAreNone)
{
  EXPECT_THROW(ScanToMap({-1, 100, {}}), std::invalid_argument);
  EXPECT_THROW(ScanToMap({1, NAN, {}}), std::invalid_argument);
  EXPECT_THROW(registration::LocalMap(0), std::invalid_argument);
}

TEST(LocalMap, IsBoundedAndForgets)
{
  registration::LocalMap map(1);
  std::vector<Eigen::Vector3d> crowd;
  crowd.reserve(2000);
  for (int i = 0; i < 2000; ++i)
  {
    crowd.emplace_back(0.0005 * i, 0.5, 0.5);
  }
  map.add(crowd);
  EXPECT_EQ(map.voxels(), 1U);
  EXPECT_LE(map.points(), registration::LocalMap::kMostPoints);
  const std::vector<Eigen::Vector3d> odd = {{NAN, 0, 0}, {1e300, 0, 0}, {50, 0, 0}};
  map.add(odd);
  EXPECT_EQ(map.voxels(), 2U);
  map.forgetBeyond(Eigen::Vector3d::Zero(), 10);
  EXPECT_EQ(map.voxels(), 1U);
  EXPECT_EQ(map.nearest({NAN, 0, 0}, 1), nullptr);
  EXPECT_EQ(map.nearest({50, 0, 0}, 1), nullptr);
  EXPECT_NE(map.nearest({0.5, 0.5, 0.6}, 1), nullptr);
}
}  // namespace
