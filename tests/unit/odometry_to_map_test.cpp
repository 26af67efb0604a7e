// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/poses/level_pose.h>
#include <traverse/registration/odometry_to_map.h>

#include <gtest/gtest.h>

#include <support/analytic_street.h>

namespace
{
using namespace traverse;
using namespace traverse::testing;
using registration::Fit;
using registration::Followed;
using registration::OdometryToMap;
constexpr poses::TimeNs kStart = 1'600'000'000'000'000'000;
constexpr double kStep = 0.05;  // s, from one scan and one step of the wheels to the next
constexpr double kRadPerDegree = std::numbers::pi / 180;

Eigen::Isometry3d place(double x, double y, double yaw)
{
  return poses::levelPose({x, y, yaw});
}

Eigen::Isometry3d standing(double /*t_s*/)
{
  return place(20, 0, 0.2);
}

/** On the street, at 1 m/s; 18.85 s are once round. */
Eigen::Isometry3d inCircles(double t_s)
{
  constexpr double kRadius = 3;
  const double angle = t_s / kRadius;
  return place(20 + kRadius * std::sin(angle), -kRadius * std::cos(angle), angle);
}

/** Up a hill that gets steeper by 5.7 degrees a metre. */
Eigen::Isometry3d uphill(double t_s)
{
  constexpr double kRadius = 10;
  const double angle = t_s / kRadius;
  Eigen::Isometry3d T = place(20 + kRadius * std::sin(angle), 0, 0);
  T.translation().z() = kRadius * (1 - std::cos(angle));
  T.linear() = Eigen::AngleAxisd(-angle, Eigen::Vector3d::UnitY()).toRotationMatrix();
  return T;
}

/** A drive, and what is wrong with the wheels of its vehicle and with its lidars. */
struct Drive
{
  AnalyticWorld world;
  SpinningLidar::Path path;
  double seconds = 5;
  double scale_error = 0.03;
  double drift_degpm = 0.5;
  double spins_from_s = 1e9;  //!< wheels turn at spins_mps more than the vehicle moves
  double spins_until_s = 1e9;
  double spins_mps = 0;
  double blind_from_s = 1e9;  //!< the lidars see nothing
};

/** What the wheels make of a drive. */
class Wheels
{
 public:
  explicit Wheels(const Drive& drive) : drive_(drive), now_(drive.path(0)) {}

  poses::PoseTrack until(double t_s)
  {
    for (; at_s_ + kStep <= t_s + 1e-9; at_s_ += kStep)
    {
      const Eigen::Isometry3d moved = drive_.path(at_s_).inverse() * drive_.path(at_s_ + kStep);
      geometry::Pose2 told = poses::seenFromAbove(moved);
      told.yaw_rad += drive_.drift_degpm * kRadPerDegree * moved.translation().norm();
      told.x_m *= 1 + drive_.scale_error;
      const bool spins = at_s_ >= drive_.spins_from_s && at_s_ < drive_.spins_until_s;
      told.x_m += spins ? drive_.spins_mps * kStep : 0;
      now_ = now_ * poses::levelPose(told);
      poses_.push_back({poses::later(kStart, at_s_ + kStep), now_});
    }
    return poses::PoseTrack(poses_);
  }

  const Eigen::Isometry3d& now() const { return now_; }

 private:
  const Drive& drive_;
  Eigen::Isometry3d now_;
  double at_s_ = 0;
  std::vector<poses::StampedPose> poses_ = {{kStart, now_}};
};

/** What became of a drive; distances in m. */
struct Off
{
  int scans = 0;
  int matched = 0;
  double worst_m = 0;
  double end_m = 0;
  double end_deg = 0;
  double step_m = 0;           //!< the most from one scan to the next
  double odometry_m = 0;       //!< odometry alone, at the end
  double from_odometry_m = 0;  //!< between it and the pose, at the end
  double deviation_m = 0;      //!< as it says itself
  double relied_until_s = 0;
};

double apart_m(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b)
{
  return (a.translation() - b.translation()).norm();
}

SpinningLidar roof()
{
  SpinningLidar lidar;
  lidar.columns = 400;
  lidar.noise_m = 0.02;
  lidar.height_m = 1.2;
  return lidar;
}

SpinningLidar front()
{
  SpinningLidar lidar = roof();
  lidar.lowest_deg = -35;
  lidar.highest_deg = -5;
  lidar.height_m = 0.7;
  return lidar;
}

/** Two lidars by turns. */
Off follow(const Drive& drive)
{
  Wheels wheels(drive);
  OdometryToMap way({}, Eigen::Isometry3d::Identity());
  Off off;
  Eigen::Isometry3d before = drive.path(0);
  for (double t_s = 2 * kStep; t_s < drive.seconds; t_s += kStep)
  {
    const bool from_roof = off.scans++ % 2 == 0;
    points::ScanBuffer scan =
        (from_roof ? roof() : front()).scan(drive.world, drive.path, t_s, kStart);
    scan.sensor_label = from_roof ? "ROOF" : "FRONT";
    if (t_s >= drive.blind_from_s)
    {
      scan.x = scan.y = scan.z = scan.time_s = {};
    }
    const Followed now = way.take(scan, wheels.until(t_s));
    const Eigen::Isometry3d truth = drive.path(t_s);
    off.matched += static_cast<int>(now.fit == Fit::matched);
    off.end_m = apart_m(now.T_map_base, truth);
    off.end_deg = Eigen::AngleAxisd(now.T_map_base.linear().transpose() * truth.linear()).angle() /
                  kRadPerDegree;
    off.worst_m = std::max(off.worst_m, off.end_m);
    off.step_m = std::max(off.step_m, apart_m(now.T_map_base, before));
    off.odometry_m = apart_m(wheels.now(), truth);
    off.from_odometry_m = apart_m(wheels.now(), now.T_map_base);
    off.deviation_m = now.deviation_m;
    off.relied_until_s = poses::secondsBetween(kStart, way.reliedOn().value_or(kStart));
    before = now.T_map_base;
  }
  return off;
}

TEST(OdometryToMap, StaysPutWhereItStands)
{
  const Off off = follow({street(60), standing});
  EXPECT_EQ(off.matched, off.scans - 2) << "each lidar's first scan is its key frame";
  EXPECT_LT(off.worst_m, 0.02);
  EXPECT_LT(off.step_m, 0.003) << "nothing jitters: the noise of a range is 2 cm";
}

TEST(OdometryToMap, PutsDriftRightOnALoop)
{
  const Off off = follow({street(60), inCircles, 18.85});
  EXPECT_EQ(off.matched, off.scans - 2);
  EXPECT_GT(off.odometry_m, 0.4) << "else there is nothing to put right";
  EXPECT_LT(off.end_m, off.odometry_m / 10);
  EXPECT_LT(off.worst_m, 0.05);
}

TEST(OdometryToMap, LeavesOdometryAsItIsOnAPlain)
{
  const Off off = follow({{}, inCircles, 10});
  // Rings of ground lie where they lay, wherever the vehicle is: they must not hold it.
  EXPECT_LT(off.from_odometry_m, 0.04) << "odometry itself is off by " << off.odometry_m;
  EXPECT_GT(off.deviation_m, 0.05) << "10 m by odometry alone are not known to centimetres";
}

TEST(OdometryToMap, ClimbsThoughOdometryIsLevel)
{
  const Off off = follow({street(60), uphill, 3});
  EXPECT_GT(off.odometry_m, 0.4) << "it knows of no hill";
  EXPECT_LT(off.worst_m, 0.06);
  EXPECT_LT(off.end_deg, 1);
}

TEST(OdometryToMap, DoesNotBelieveWheelsThatSpin)
{
  Drive drive{street(60), standing, 4};
  drive.spins_from_s = 1;
  drive.spins_until_s = 2;
  drive.spins_mps = 1;
  const Off off = follow(drive);
  EXPECT_GT(off.odometry_m, 0.9);
  EXPECT_LT(off.worst_m, 0.3) << "it lags while they spin, for a second";
  EXPECT_LT(off.end_m, 0.03);
}

TEST(OdometryToMap, CarriesOnBlindForAWhileOnly)
{
  Drive drive{street(60), inCircles, 4};
  drive.blind_from_s = 2;
  const Off off = follow(drive);
  EXPECT_LT(off.worst_m, 0.2) << "odometry goes on";
  // A metre (FollowParams::carried_m) at 1 m/s, of which odometry makes 1.03 m; scans of 0.05 s.
  EXPECT_NEAR(off.relied_until_s, 3, 0.1);
}

TEST(OdometryToMap, SurvivesOddInput)
{
  OdometryToMap way({}, Eigen::Isometry3d::Identity());
  points::ScanBuffer empty;
  EXPECT_EQ(way.take(empty, {}).fit, Fit::no_odometry);
  const auto here = poses::PoseTrack::constant(Eigen::Isometry3d::Identity());
  EXPECT_EQ(way.take(empty, here).fit, Fit::too_few_points);
  points::ScanBuffer odd;
  for (int i = 0; i < 5000; ++i)
  {
    odd.x.push_back(i % 7 == 0 ? NAN : 3);
    odd.y.push_back(i % 11 == 0 ? INFINITY : 0);
    odd.z.push_back(1e30F);
  }
  EXPECT_EQ(way.take(odd, here).fit, Fit::too_few_points);
  EXPECT_THROW(OdometryToMap({0}, Eigen::Isometry3d::Identity()), std::invalid_argument);
  EXPECT_THROW(OdometryToMap({0.5, NAN}, Eigen::Isometry3d::Identity()), std::invalid_argument);
}
}  // namespace
