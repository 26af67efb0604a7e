// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// One turn of each lidar in scenes whose ranges are known.
#include "support/simulated_turns.h"

#include <traverse/sensors/velodyne_packet.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace traverse::testing
{
namespace
{
using sensors::VelodyneModel;
using simulation::LidarParams;
using simulation::LidarTurn;
using simulation::ReturnTruth;

constexpr std::array<VelodyneModel, 3> kModels = {
    VelodyneModel::hdl32e, VelodyneModel::vlp16, VelodyneModel::vlp32c};

/** Ground, a wall on one side, a ball on the other. */
simulation::Scene yard()
{
  simulation::Scene scene = planeScene(-0.3);
  scene.area = {-30, -30, 30, 30};
  scene.objects.push_back(boxObject({8, -50, -1}, {9, 50, 20}));
  simulation::Object ball;
  ball.label = simulation::Label::structure;
  ball.balls.push_back({{-10, 2, 3}, 4, simulation::Material::brick});
  scene.objects.push_back(ball);
  return scene;
}

double rangeOf(const points::ScanBuffer& scan, size_t i, const LidarTurn& turn)
{
  const Eigen::Vector3d p(
      static_cast<double>(scan.x[i]), static_cast<double>(scan.y[i]),
      static_cast<double>(scan.z[i]));
  return (p - turn.T_base_sensor.translation()).norm();
}

/** Half a count of the distance, single precision of the ray and of the point (1e-5 m each). */
double rangeTolerance(VelodyneModel model)
{
  return sensors::factoryCalibration(model).distance_unit_m / 2 + 3e-5;
}

class LidarInAYard : public ::testing::TestWithParam<VelodyneModel>
{
};

TEST_P(LidarInAYard, HasATruthForEveryPoint)
{
  const LidarTurn turn = turnIn(yard(), perfectLidar(GetParam()));
  const points::Decoded scan = decodeTurn(turn);
  ASSERT_EQ(scan.scan.size(), turn.returns.size());
  ASSERT_GT(turn.returns.size(), 10'000U);
  EXPECT_EQ(scan.rejects.of(points::Reject::bad_packet), 0U);
  for (size_t i = 0; i < turn.returns.size(); ++i)
  {
    EXPECT_NEAR(
        rangeOf(scan.scan, i, turn), static_cast<double>(turn.returns[i].range_m),
        rangeTolerance(GetParam()));
  }
}

/** How far a point lies from the surface that its truth names. */
double offSurface(const points::ScanBuffer& scan, size_t i, const ReturnTruth& truth)
{
  const Eigen::Vector3d p(
      static_cast<double>(scan.x[i]), static_cast<double>(scan.y[i]),
      static_cast<double>(scan.z[i]));
  switch (truth.object)
  {
    case simulation::Scene::kGround:
      return std::abs(p.z() + 0.3);
    case simulation::Scene::kFirstObject:
      return std::abs(p.x() - 8);
    default:
      return std::abs((p - Eigen::Vector3d(-10, 2, 3)).norm() - 4);
  }
}

TEST_P(LidarInAYard, MeetsTheSurfacesThatTheTruthNames)
{
  const LidarTurn turn = turnIn(yard(), perfectLidar(GetParam()));
  const points::Decoded scan = decodeTurn(turn);
  ASSERT_EQ(scan.scan.size(), turn.returns.size());
  std::array<size_t, 5> of_object{};
  for (size_t i = 0; i < turn.returns.size(); ++i)
  {
    const ReturnTruth& truth = turn.returns[i];
    ++of_object.at(truth.object);
    // A packet rounds its azimuths to 0.01 degree; the step behind its last block is its
    // neighbour's, so that up to 0.015 degree are off.
    const double sideways_m = 0.015 * std::numbers::pi / 180 * static_cast<double>(truth.range_m);
    const bool slants = truth.object == simulation::Scene::kFirstObject + 1;
    const double steepest =
        slants ? 1
               : std::abs(static_cast<double>(scan.scan.y[i])) / static_cast<double>(truth.range_m);
    const double on_surface = truth.object == simulation::Scene::kGround ? 0 : steepest;
    EXPECT_LE(
        offSurface(scan.scan, i, truth), sideways_m * on_surface + rangeTolerance(GetParam()));
  }
  EXPECT_EQ(of_object[simulation::Scene::kNoObject], 0U);
  EXPECT_GT(of_object[simulation::Scene::kGround], 1000U);
  EXPECT_GT(of_object[simulation::Scene::kFirstObject], 1000U);
  EXPECT_GT(of_object[simulation::Scene::kFirstObject + 1], 100U);
}

TEST_P(LidarInAYard, SendsAsManyBeamsAsTheDataSheetSays)
{
  // 0.7, 0.3 and 0.6 million beams a second, of the manuals; the VLP's recharge counts.
  const std::array<double, 3> beams_per_s = {695'000, 289'000, 579'000};
  simulation::RayCaster scene(planeScene());
  const simulation::Lidar lidar(perfectLidar(GetParam()), 1);
  size_t packets = 0;
  for (uint64_t k = 0; k < 10; ++k)
  {
    packets += lidar.turn(k, scene, standingStill()).packets.size();
  }
  const double expected = beams_per_s.at(static_cast<size_t>(GetParam()));
  EXPECT_NEAR(static_cast<double>(packets) * 384, expected, 0.01 * expected);
}

TEST_P(LidarInAYard, GivesTheSameBytesForASeedAndOthersForAnother)
{
  LidarParams params;
  params.model = GetParam();
  params.rain_share = 0.1;
  params.drop_out = 0.1;
  const simulation::RayCaster scene(yard());
  const auto turn = [&](uint64_t seed, uint64_t k)
  { return simulation::Lidar(params, seed).turn(k, scene, standingStill()); };
  const LidarTurn one = turn(7, 3);
  turn(7, 2);
  const LidarTurn again = turn(7, 3);
  EXPECT_EQ(one.packets, again.packets);
  EXPECT_EQ(one.returns, again.returns);
  EXPECT_NE(one.packets, turn(8, 3).packets);
}

INSTANTIATE_TEST_SUITE_P(
    Models,
    LidarInAYard,
    ::testing::ValuesIn(kModels),
    [](const auto& tested) { return "Model" + std::to_string(static_cast<int>(tested.param)); });

TEST(SimulatedLidar, TurnsFollowEachOtherWithoutAGap)
{
  const simulation::RayCaster scene(planeScene());
  const simulation::Lidar lidar(perfectLidar(VelodyneModel::hdl32e), 1);
  const double packet_s = 12 * 46.08e-6;
  for (uint64_t k = 0; k < 12; ++k)
  {
    const LidarTurn turn = lidar.turn(k, scene, standingStill());
    const double until_next_s =
        poses::secondsBetween(turn.stamp, lidar.turn(k + 1, scene, standingStill()).stamp);
    // stamps are whole microseconds
    EXPECT_NEAR(until_next_s, static_cast<double>(turn.packets.size()) * packet_s, 1e-6);
  }
}

TEST(SimulatedLidar, CountsItsClockFromTheTopOfTheHour)
{
  LidarParams params = perfectLidar(VelodyneModel::vlp16);
  params.clock_offset_s = -0.05;  // the hour is full in the middle of the turn
  const LidarTurn turn = turnIn(planeScene(), params);
  const auto first = sensors::VelodyneData::check(turn.packets.front());
  const auto last = sensors::VelodyneData::check(turn.packets.back());
  ASSERT_TRUE(first && last);
  EXPECT_EQ(first->timeUs(), 3'599'950'000U);
  EXPECT_LT(last->timeUs(), 60'000U);
  EXPECT_EQ(turn.stamp, simulation::kRecordingStart - 50'000'000);
  const points::Decoded scan = decodeTurn(turn);
  EXPECT_NEAR(static_cast<double>(scan.scan.time_s.back()), 0.1, 0.002);
}

TEST(SimulatedLidar, HasTheNoiseThatItIsAskedFor)
{
  LidarParams params = perfectLidar(VelodyneModel::hdl32e);
  params.range_noise_m = 0.02;
  const LidarTurn turn = turnIn(yard(), params);
  const points::Decoded scan = decodeTurn(turn);
  ASSERT_EQ(scan.scan.size(), turn.returns.size());
  double sum = 0;
  double squares = 0;
  for (size_t i = 0; i < turn.returns.size(); ++i)
  {
    const double error = rangeOf(scan.scan, i, turn) - static_cast<double>(turn.returns[i].range_m);
    sum += error;
    squares += error * error;
  }
  const auto n = static_cast<double>(turn.returns.size());
  EXPECT_NEAR(sum / n, 0, 5 * 0.02 / std::sqrt(n));
  // the deviation of a deviation is 1 / sqrt(2 n); rounding to 2 mm adds 0.04 %
  EXPECT_NEAR(std::sqrt(squares / n), 0.02, 0.02 * (5 / std::sqrt(2 * n) + 0.001));
}

TEST(SimulatedLidar, LosesTheShareOfReturnsThatItIsAskedTo)
{
  LidarParams params = perfectLidar(VelodyneModel::hdl32e);
  const auto all = static_cast<double>(turnIn(yard(), params).returns.size());
  params.drop_out = 0.25;
  const auto left = static_cast<double>(turnIn(yard(), params).returns.size());
  EXPECT_NEAR(left / all, 0.75, 5 * std::sqrt(0.25 * 0.75 / all));
}

TEST(SimulatedLidar, SeesDarkAndSlantingSurfacesLessFar)
{
  LidarParams params = perfectLidar(VelodyneModel::hdl32e);
  simulation::Scene scene = planeScene();
  const auto farthest = [](const LidarTurn& turn)
  {
    float most = 0;
    for (const ReturnTruth& truth : turn.returns)
    {
      most = std::max(most, truth.range_m);
    }
    return most;
  };
  EXPECT_GT(farthest(turnIn(scene, params)), 70);  // the ring at -1.33 degrees
  params.half_range_m = 100;
  EXPECT_LT(farthest(turnIn(scene, params)), 60);
}

size_t raindrops(const LidarTurn& turn)
{
  size_t drops = 0;
  for (const ReturnTruth& truth : turn.returns)
  {
    if (truth.object == simulation::Scene::kNoObject)
    {
      ++drops;
      EXPECT_EQ(truth.label, simulation::Label::none);
      EXPECT_LE(truth.range_m, 15.0F);
    }
  }
  return drops;
}

TEST(SimulatedLidar, InRainReportsDropsUnlessItReportsWhatIsBehindThem)
{
  LidarParams params = perfectLidar(VelodyneModel::hdl32e);
  params.rain_share = 0.1;
  const LidarTurn strongest = turnIn(yard(), params);
  params.mode = sensors::ReturnMode::last;
  const LidarTurn last = turnIn(yard(), params);
  EXPECT_GT(raindrops(strongest), strongest.returns.size() / 20);
  EXPECT_LT(raindrops(last), raindrops(strongest) / 2);
  EXPECT_EQ(decodeTurn(strongest).scan.size(), strongest.returns.size());
}

TEST(SimulatedLidar, RefusesDualModeAndOptionsOutOfRange)
{
  LidarParams params;
  params.mode = sensors::ReturnMode::dual;
  EXPECT_THROW(simulation::Lidar(params, 1), std::invalid_argument);
  params.mode = sensors::ReturnMode::last;
  params.rate_hz = 0;
  EXPECT_THROW(simulation::Lidar(params, 1), options::OptionError);
}
}  // namespace
}  // namespace traverse::testing
