// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/points/deskew.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
using namespace traverse;
using points::Deskew;
using points::ScanBuffer;

constexpr poses::TimeNs kStart = 1'600'000'000'000'000'000;

/** A car at 20 m/s that turns at 0.5 rad/s, a pose every 10 ms for 2 s. */
Eigen::Isometry3d carAt(double t_s)
{
  const double v = 20;
  const double w = 0.5;
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = Eigen::AngleAxisd(w * t_s, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  T.translation() =
      Eigen::Vector3d(v / w * std::sin(w * t_s), v / w * (1 - std::cos(w * t_s)), 0.3);
  return T;
}

poses::PoseTrack car()
{
  std::vector<poses::StampedPose> all;
  for (int i = 0; i <= 200; ++i)
  {
    all.push_back({kStart + i * 10'000'000, carAt(i * 0.01)});
  }
  return poses::PoseTrack(all);
}

/** A post at one place of the map, as the car sees it over a 0.1 s turn that starts at 1 s. */
ScanBuffer postSeenFromTheCar(const Eigen::Vector3d& post)
{
  ScanBuffer scan;
  scan.stamp = kStart + 1'000'000'000;
  for (int i = -50; i < 50; ++i)
  {
    const double t = i * 0.001;
    const Eigen::Vector3d p = carAt(1 + t).inverse() * post;
    scan.x.push_back(static_cast<float>(p.x()));
    scan.y.push_back(static_cast<float>(p.y()));
    scan.z.push_back(static_cast<float>(p.z()));
    scan.time_s.push_back(static_cast<float>(t));
  }
  return scan;
}

TEST(Deskew, PutsAPostBackIntoOnePlace)
{
  const Eigen::Vector3d post(30, 5, 1);
  ScanBuffer scan = postSeenFromTheCar(post);
  const Eigen::Vector3d seen = carAt(1).inverse() * post;
  EXPECT_GT(std::abs(scan.x.front() - seen.x()), 0.9) << "without correction it is a metre off";
  EXPECT_EQ(points::deskew(scan, car()), Deskew::corrected);
  for (size_t i = 0; i < scan.size(); ++i)
  {
    // 10 ms chords of this curve stray 0.12 mm; float keeps 30 m to 2 um.
    EXPECT_NEAR(scan.x[i], seen.x(), 5e-4);
    EXPECT_NEAR(scan.y[i], seen.y(), 5e-4);
    EXPECT_NEAR(scan.z[i], seen.z(), 5e-4);
  }
}

TEST(Deskew, LeavesAScanOutsideTheTrackAsItWas)
{
  ScanBuffer scan = postSeenFromTheCar({30, 5, 1});
  scan.stamp = kStart + 900'000'000'000;
  const std::vector<float> before = scan.x;
  EXPECT_EQ(points::deskew(scan, car()), Deskew::no_poses);
  EXPECT_EQ(scan.x, before);
}

TEST(Deskew, LeavesAScanWithAnAbsurdTimeAsItWas)
{
  for (const float absurd : {1e30F, std::numeric_limits<float>::quiet_NaN()})
  {
    ScanBuffer scan = postSeenFromTheCar({30, 5, 1});
    scan.time_s[7] = absurd;
    EXPECT_EQ(points::deskew(scan, car()), Deskew::no_poses);
  }
}

TEST(Deskew, NeedsTimesAndMotion)
{
  ScanBuffer scan = postSeenFromTheCar({30, 5, 1});
  EXPECT_EQ(points::deskew(scan, poses::PoseTrack::constant(carAt(0))), Deskew::not_needed);
  scan.time_s.clear();
  EXPECT_EQ(points::deskew(scan, car()), Deskew::not_needed);
}
}  // namespace
