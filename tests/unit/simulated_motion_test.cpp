// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// A car that drives a bend at 15 m/s past a wall and another car that moves: every point, with the
// exact trajectory, lies on the surface that it came from.
#include "support/simulated_turns.h"

#include <traverse/points/deskew.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace traverse::testing
{
namespace
{
using simulation::kRecordingStart;
using simulation::LidarTurn;
using simulation::Recording;
using simulation::Scene;

constexpr double kWall_m = 25;
constexpr float kHalfLength_m = 2;
constexpr float kHalfWidth_m = 1;
constexpr uint32_t kWall = Scene::kFirstObject;
constexpr uint32_t kCar = Scene::kFirstObject + 1;

simulation::Object movingCar()
{
  std::vector<simulation::TimedPose> poses;
  for (int i = 0; i <= 10; ++i)
  {
    simulation::TimedPose pose;
    pose.t_s = 0.2 * i;
    pose.T_map_body.linear() = poses::rotationBy(0.1 * i, Eigen::Vector3d::UnitZ());
    pose.T_map_body.translation() = Eigen::Vector3d(5 + 2.4 * i, -8 + 0.3 * i, 0);
    poses.push_back(pose);
  }
  simulation::Object car =
      boxObject({-kHalfLength_m, -kHalfWidth_m, 0.2F}, {kHalfLength_m, kHalfWidth_m, 1.5F});
  car.label = simulation::Label::vehicle;
  car.motion = simulation::Motion(poses);
  return car;
}

Scene street()
{
  Scene scene = planeScene();
  scene.area = {-50, -50, 50, 50};
  scene.objects.push_back(boxObject({-80, kWall_m, -1}, {80, kWall_m + 1, 10}));
  scene.objects.push_back(movingCar());
  return scene;
}

simulation::RecordingParams bend(sensors::VelodyneModel model)
{
  simulation::RecordingParams params;
  params.vehicle.base_height_m = 0.3;
  params.drive.xs_m = {-4, 0, 8, 14};
  params.drive.ys_m = {0, 0, 3, 8};
  params.drive.speed_mps = 15;
  params.drive.accel_mps2 = 0;
  params.lidars = {perfectLidar(model)};
  params.lidars.front().pitch_deg = 5;
  params.lidars.front().yaw_deg = 77;
  params.lidars.front().x_m = 0.8;
  return params;
}

Eigen::Vector3d pointOf(const points::ScanBuffer& scan, size_t i)
{
  return {
      static_cast<double>(scan.x[i]), static_cast<double>(scan.y[i]),
      static_cast<double>(scan.z[i])};
}

double offCar(const Eigen::Vector3d& p_map, double t_s)
{
  const Eigen::Vector3d p = movingCar().motion.at(t_s).inverse() * p_map;
  const double x = std::abs(p.x()) - static_cast<double>(kHalfLength_m);
  const double y = std::abs(p.y()) - static_cast<double>(kHalfWidth_m);
  const double z = std::abs(p.z() - 0.85) - 0.65;
  return std::abs(std::max({x, y, z}));
}

/** The largest distance of a point from its surface, for ground, wall and car. */
std::array<double, 3> worstOf(
    const points::ScanBuffer& scan, const LidarTurn& turn, const Eigen::Isometry3d& T_map_base)
{
  std::array<double, 3> worst{};
  for (size_t i = 0; i < scan.size(); ++i)
  {
    const Eigen::Vector3d p = T_map_base * pointOf(scan, i);
    const double t_s =
        poses::secondsBetween(kRecordingStart, scan.stamp) + static_cast<double>(scan.time_s[i]);
    const uint32_t object = turn.returns[i].object;
    const double off = object == Scene::kGround ? std::abs(p.z())
                       : object == kWall        ? std::abs(p.y() - kWall_m)
                                                : offCar(p, t_s);
    const size_t kind = object == Scene::kGround ? 0 : object == kWall ? 1 : 2;
    // the wall's other faces are seen from its ends only
    const bool other_face = object == kWall && off > 0.5;
    worst.at(kind) = other_face ? worst.at(kind) : std::max(worst.at(kind), off);
  }
  return worst;
}

class LidarInABend : public ::testing::TestWithParam<sensors::VelodyneModel>
{
};

TEST_P(LidarInABend, PutsDeskewedPointsOnTheirSurfaces)
{
  Recording recording(street(), bend(GetParam()), 1);
  const poses::PoseTrack track(recording.trajectory(100));
  const double count_m = sensors::factoryCalibration(GetParam()).distance_unit_m;
  size_t of_car = 0;
  for (const LidarTurn& turn : eventsOf<LidarTurn>(recording))
  {
    points::ScanBuffer scan = decodeTurn(turn).scan;
    ASSERT_EQ(scan.size(), turn.returns.size());
    ASSERT_EQ(points::deskew(scan, track), points::Deskew::corrected);
    const auto worst = worstOf(scan, turn, track.at(scan.stamp)->T_map_base);
    // Half a count of the distance, half a microsecond of the clock at 15 m/s, single precision;
    // azimuths are rounded by up to 0.015 degree, 0.02 m at the 80 m to the wall's ends. On the
    // level ground an azimuth error shows by the sensor's tilt of 5 degrees.
    const double turned = 0.015 * std::numbers::pi / 180;
    EXPECT_LT(worst[0], count_m / 2 + 100 * turned * std::sin(5 * std::numbers::pi / 180) + 2e-4);
    EXPECT_LT(worst[1], count_m / 2 + 100 * turned + 2e-4);
    EXPECT_LT(worst[2], count_m / 2 + 40 * turned + 2e-4);
    of_car += static_cast<size_t>(std::count_if(
        turn.returns.begin(), turn.returns.end(),
        [](const simulation::ReturnTruth& truth) { return truth.object == kCar; }));
  }
  EXPECT_GT(of_car, 300U);
}

TEST_P(LidarInABend, IsFarOffWithoutDeskewing)
{
  const Recording recording(street(), bend(GetParam()), 1);
  const auto turn = std::get<LidarTurn>(recording.make({0, 0, 1}));
  const auto scan = decodeTurn(turn).scan;
  const auto pose = recording.drive().at(poses::secondsBetween(kRecordingStart, scan.stamp));
  EXPECT_GT(worstOf(scan, turn, pose)[1], 0.3);
}

INSTANTIATE_TEST_SUITE_P(
    Models,
    LidarInABend,
    ::testing::Values(
        sensors::VelodyneModel::hdl32e,
        sensors::VelodyneModel::vlp16,
        sensors::VelodyneModel::vlp32c),
    [](const auto& tested) { return "Model" + std::to_string(static_cast<int>(tested.param)); });
}  // namespace
}  // namespace traverse::testing
