// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/poses/pose_track.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace
{
using namespace traverse::poses;

constexpr TimeNs kSecond = 1'000'000'000;

StampedPose at(double t_s, double x, double yaw = 0)
{
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  T.translation().x() = x;
  return {static_cast<TimeNs>(t_s * kSecond), T};
}

double xAt(const PoseTrack& track, double t_s)
{
  const auto pose = track.at(static_cast<TimeNs>(t_s * kSecond));
  return pose ? pose->T_map_base.translation().x() : std::nan("");
}

TEST(PoseTrack, InterpolatesBetweenStampedPoses)
{
  const PoseTrack straight({at(10, 0), at(10.5, 1)});
  EXPECT_NEAR(xAt(straight, 10.125), 0.25, 1e-12);
  EXPECT_EQ(straight.at(10 * kSecond + kSecond / 4)->quality, PoseQuality::interpolated);
  const auto turning = PoseTrack({at(10, 0), at(10.5, 1, 0.2)}).at(10 * kSecond + kSecond / 4);
  EXPECT_NEAR(Eigen::AngleAxisd(turning->T_map_base.linear()).angle(), 0.1, 1e-12);
}

TEST(PoseTrack, FollowsTheArcOfACarThatTurns)
{
  // 20 m/s on a circle of 40 m, a pose every 0.5 s: half-way, the chord is 31 cm off the arc.
  const auto car = [](double t_s)
  {
    const double radius = 40;
    const double yaw = 20 / radius * t_s;
    StampedPose pose = at(t_s, radius * std::sin(yaw), yaw);
    pose.T_map_base.translation().y() = radius * (1 - std::cos(yaw));
    return pose;
  };
  const PoseTrack track({car(10), car(10.5)});
  for (const double t : {10.1, 10.25, 10.4, 10.7})
  {
    const auto pose = track.at(static_cast<TimeNs>(t * kSecond));
    const Eigen::Isometry3d error = pose->T_map_base.inverse() * car(t).T_map_base;
    EXPECT_LT(error.translation().norm(), 1e-6) << t;  // time is rounded to 1 ns: 20 nm
  }
}

TEST(PoseTrack, LooksUpByTimeNotByArrival)
{
  const PoseTrack track({at(11, 2), at(10, 0), at(10.5, 1)});
  EXPECT_NEAR(xAt(track, 10.75), 1.5, 1e-12);
  EXPECT_EQ(track.report().backward, 1U);
}

TEST(PoseTrack, GoesOnWithTheLastVelocityForABoundedTime)
{
  const PoseTrack track({at(10, 0), at(10.5, 1)}, {.max_pose_age_s = 0.6});
  EXPECT_NEAR(xAt(track, 10.75), 1.5, 1e-12);
  EXPECT_NEAR(xAt(track, 9.75), -0.5, 1e-12);
  EXPECT_EQ(track.at(11 * kSecond)->quality, PoseQuality::extrapolated);
  EXPECT_TRUE(std::isnan(xAt(track, 11.2))) << "a pose is never used when it is too old";
}

TEST(PoseTrack, TwoPosesOfNearlyTheSameTimeGiveNoVelocity)
{
  const PoseTrack jitter({at(10, 0), at(10.00001, 0.04)});
  EXPECT_NEAR(xAt(jitter, 10.5), 0.04, 1e-12) << "4 cm in 10 us is noise, not 4 km/s";
  EXPECT_EQ(jitter.at(10 * kSecond + kSecond / 2)->quality, PoseQuality::held);
  const PoseTrack longer({at(9.5, -1), at(10, 0), at(10.00001, 0.04)});
  EXPECT_NEAR(xAt(longer, 10.25), 0.56, 1e-3) << "the velocity of the last half second";
}

TEST(PoseTrack, HasNoPoseInsideAGap)
{
  const PoseTrack track({at(10, 0), at(20, 10)}, {.max_pose_age_s = 1});
  EXPECT_TRUE(std::isnan(xAt(track, 15)));
  EXPECT_EQ(track.at(10 * kSecond + kSecond / 2)->quality, PoseQuality::held);
  EXPECT_EQ(track.report().gaps, 1U);
}

TEST(PoseTrack, AJumpStartsANewSegment)
{
  const PoseTrack track({at(10, 0), at(10.1, 0.1), at(10.2, 500), at(10.3, 500.1)});
  EXPECT_EQ(track.report().segments, 2U);
  EXPECT_NEAR(xAt(track, 10.14), 0.14, 1e-9)
      << "from the segment before, not smeared across the jump";
  EXPECT_NEAR(xAt(track, 10.16), 499.96, 1e-9);
}

TEST(PoseTrack, ATurnOnTheSpotThatIsTooFastIsAJump)
{
  const PoseTrack track({at(10, 0), at(10.01, 0, std::numbers::pi / 2)});
  EXPECT_EQ(track.report().segments, 2U);
}

TEST(PoseTrack, DropsPosesThatAreNone)
{
  StampedPose nan = at(11, std::numeric_limits<double>::quiet_NaN());
  StampedPose scaled = at(12, 0);
  scaled.T_map_base.linear() *= 2;
  StampedPose far = at(13, 1e9);
  const PoseTrack track({at(10, 0), nan, scaled, far, at(10, 7)});
  EXPECT_EQ(track.report().nonfinite, 3U);
  EXPECT_EQ(track.report().repeated, 1U);
  EXPECT_EQ(track.report().poses, 1U);
  EXPECT_EQ(xAt(track, 10), 0) << "of a repeated stamp the first is kept";
}

TEST(PoseTrack, EmptyHasNoPose)
{
  EXPECT_FALSE(PoseTrack().at(0));
  EXPECT_EQ(PoseTrack().report().segments, 0U);
}

TEST(PoseTrack, ConstantIsValidForAllTime)
{
  const PoseTrack track = PoseTrack::constant(at(0, 3).T_map_base);
  EXPECT_EQ(xAt(track, 1e6), 3);
  EXPECT_FALSE(track.moves());
}
}  // namespace
