// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/simulated_velodyne.h"

#include <traverse/points/velodyne_scan.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace traverse::testing
{
namespace
{
using points::Beam;
using points::Reject;
using sensors::ReturnMode;
using sensors::VelodyneModel;
using sensors::VelodyneReturn;

using Pair = std::array<VelodyneReturn, 2>;

/** Everything is so many counts away. */
SimulatedVelodyne::World sphere(uint16_t count)
{
  return [count](int, double) { return Pair{{{count, 51}, {count, 51}}}; };
}

TEST(DecodeVelodyne, LooksAlongXAtAzimuthZeroAndTurnsTowardsMinusY)
{
  SimulatedVelodyne sensor;
  sensor.rate_dps = 0;
  const auto ahead = decode(sensor.run(1, sphere(5000)));
  ASSERT_EQ(ahead.scan.size(), 384U);
  const double c = 10 * std::cos(15 * std::numbers::pi / 180);  // laser 0: 15 degrees down
  EXPECT_NEAR(ahead.scan.x[0], c, 1e-6);
  EXPECT_NEAR(ahead.scan.y[0], 0, 1e-6);
  EXPECT_NEAR(ahead.scan.z[0], -10 * std::sin(15 * std::numbers::pi / 180), 1e-6);
  EXPECT_FLOAT_EQ(ahead.scan.intensity[0], 51.0F / 255);
  sensor.start_deg = 90;
  const auto right = decode(sensor.run(1, sphere(5000)));
  EXPECT_NEAR(right.scan.x[0], 0, 1e-6);
  EXPECT_NEAR(right.scan.y[0], -c, 1e-6);
}

TEST(DecodeVelodyne, PutsPointsIntoTheVehicleFrame)
{
  SimulatedVelodyne sensor;
  sensor.rate_dps = 0;
  points::VelodyneInput input;
  input.stamp = 123;
  input.sensor_label = "roof";
  input.T_base_sensor.translation() = Eigen::Vector3d(1, 2, 3);
  input.T_base_sensor.linear() =
      Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const auto out = decode(sensor.run(1, sphere(5000)), input);
  const double c = 10 * std::cos(15 * std::numbers::pi / 180);
  EXPECT_NEAR(out.scan.x[0], 1, 1e-5);
  EXPECT_NEAR(out.scan.y[0], 2 + c, 1e-5);
  EXPECT_EQ(out.scan.stamp, 123);
  EXPECT_EQ(out.scan.sensor_label, "roof");
  EXPECT_EQ(out.image.sensor_label, "roof");
  EXPECT_EQ(out.image.T_base_sensor.translation().z(), 3);
}

TEST(DecodeVelodyne, TimesEachFiringByTheManual)
{
  const auto out = decode(SimulatedVelodyne{}.run(2, sphere(5000)));
  EXPECT_NEAR(out.scan.time_s[1], 2.304e-6, 1e-9);
  EXPECT_NEAR(out.scan.time_s[16], 55.296e-6, 1e-9);
  EXPECT_NEAR(out.scan.time_s[32], 110.592e-6, 1e-9);
  // The packets' clock counts whole microseconds: 1327 for 1327.104.
  EXPECT_NEAR(out.scan.time_s[384], 1327e-6, 1e-9);
}

TEST(DecodeVelodyne, FollowsTheClockOverTheHour)
{
  SimulatedVelodyne sensor;
  sensor.start_us = 3'599'999'000;
  const auto out = decode(sensor.run(3, sphere(5000)));
  EXPECT_NEAR(out.scan.time_s[384], 1327e-6, 1e-9);
  EXPECT_NEAR(out.scan.time_s[768], 2654e-6, 1e-9);
}

TEST(DecodeVelodyne, PlacesAPacketBehindItsPredecessorWhereTheClockJumps)
{
  Capture capture = SimulatedVelodyne{}.run(4, sphere(5000));
  capture.packets[1][1203] = 0x7F;  // half an hour later
  const auto out = decode(capture);
  EXPECT_NEAR(out.scan.time_s[384], 1327.104e-6, 1e-8);
  EXPECT_NEAR(out.scan.time_s[768], 2 * 1327.104e-6, 1e-8);
  EXPECT_NEAR(out.scan.time_s[1152], 3 * 1327.104e-6, 1e-6);
}

TEST(DecodeVelodyne, TakesPacketsOutOfOrderByTheirTime)
{
  Capture capture = SimulatedVelodyne{}.run(4, sphere(5000));
  std::swap(capture.packets[1], capture.packets[2]);
  const auto out = decode(capture);
  EXPECT_NEAR(out.scan.time_s[384], 2654e-6, 1e-8);
  EXPECT_NEAR(out.scan.time_s[768], 1327e-6, 1e-8);
}

TEST(DecodeVelodyne, CountsWhatIsOutsideTheLimits)
{
  const SimulatedVelodyne::World world = [](int laser, double)
  {
    constexpr std::array<uint16_t, 4> kCounts = {0, 200, 5000, 60000};  // -, 0.4, 10, 120 m
    const VelodyneReturn r{kCounts[static_cast<size_t>(laser) % 4], 1};
    return Pair{{r, r}};
  };
  points::VelodyneInput input;
  input.limits = {1, 100};
  const auto out = decode(SimulatedVelodyne{}.run(1, world), input);
  EXPECT_EQ(out.scan.size(), 96U);
  EXPECT_EQ(out.rejects.of(Reject::no_return), 96U);
  EXPECT_EQ(out.rejects.of(Reject::below_range), 96U);
  EXPECT_EQ(out.rejects.of(Reject::beyond_range), 96U);
  EXPECT_EQ(std::count(out.image.beam.begin(), out.image.beam.end(), Beam::hit), 96);
  EXPECT_EQ(std::count(out.image.beam.begin(), out.image.beam.end(), Beam::no_return), 192);
  EXPECT_EQ(std::count(out.image.beam.begin(), out.image.beam.end(), Beam::rejected), 96);
}

TEST(DecodeVelodyne, YieldsBothReturnsOfDualModeAndEqualOnesOnce)
{
  SimulatedVelodyne sensor;
  sensor.mode = ReturnMode::dual;
  const SimulatedVelodyne::World world = [](int laser, double)
  {
    constexpr std::array<Pair, 4> kPairs = {
        {{{{6000, 10}, {5000, 90}}},  // two
         {{{5000, 90}, {5000, 90}}},  // one, told twice
         {{{0, 0}, {5000, 90}}},      // one
         {{{0, 0}, {0, 0}}}}};        // none
    return kPairs[static_cast<size_t>(laser) % 4];
  };
  const auto out = decode(sensor.run(1, world));
  EXPECT_EQ(out.scan.size(), 6U * 32U);
  EXPECT_EQ(out.rejects.of(Reject::no_return), 6U * 8U);
  EXPECT_EQ(out.rejects.of(Reject::flagged), 0U);
  EXPECT_FLOAT_EQ(out.scan.intensity[0], 10.0F / 255) << "last";
  EXPECT_FLOAT_EQ(out.scan.intensity[1], 90.0F / 255) << "strongest";
  EXPECT_EQ(out.scan.time_s[0], out.scan.time_s[1]);
  EXPECT_EQ(out.image.columns, 12);
  const size_t first_fired = out.image.index(0, 11);
  EXPECT_FLOAT_EQ(out.image.range_m[first_fired], 10.0F) << "the nearer of the two";
}

TEST(DecodeVelodyne, TakesLastReturnPacketsLikeStrongestOnes)
{
  SimulatedVelodyne sensor;
  const auto strongest = decode(sensor.run(3, sphere(4321)));
  sensor.mode = ReturnMode::last;
  const auto last = decode(sensor.run(3, sphere(4321)));
  EXPECT_EQ(last.scan.size(), 3U * 384U);
  EXPECT_EQ(last.scan.x, strongest.scan.x);
  EXPECT_EQ(last.scan.time_s, strongest.scan.time_s);
}

TEST(DecodeVelodyne, CountsForeignPackets)
{
  Capture capture = SimulatedVelodyne{}.run(4, sphere(5000));
  SimulatedVelodyne other;
  other.model = VelodyneModel::hdl32e;
  capture.packets.insert(capture.packets.begin() + 2, other.run(1, sphere(5000)).packets[0]);
  capture.packets.emplace_back(sensors::kVelodynePositionBytes);
  capture.packets.emplace_back();
  const auto out = decode(capture);
  EXPECT_EQ(out.rejects.of(Reject::bad_packet), 3U);
  EXPECT_EQ(out.scan.size(), 4U * 384U);
}

TEST(DecodeVelodyne, YieldsNothingButCountsWhereNothingIsGood)
{
  const auto none = decode(Capture{});
  EXPECT_EQ(none.scan.size(), 0U);
  EXPECT_EQ(none.image.rows, 0);
  Capture junk;
  junk.packets.assign(5, std::vector<uint8_t>(sensors::kVelodynePacketBytes, 0xAA));
  const auto out = decode(junk);
  EXPECT_EQ(out.rejects.of(Reject::bad_packet), 5U);
  EXPECT_EQ(out.image.size(), 0U);
}

TEST(DecodeVelodyne, RefusesACalibrationThatDoesNotFit)
{
  sensors::VelodyneCalibration calibration = sensors::factoryCalibration(VelodyneModel::vlp16);
  calibration.lasers.resize(15);
  points::VelodyneInput input;
  input.calibration = &calibration;
  const auto out = decode(SimulatedVelodyne{}.run(4, sphere(5000)), input);
  EXPECT_EQ(out.scan.size(), 0U);
  EXPECT_EQ(out.rejects.of(Reject::bad_packet), 4U);
}

TEST(DecodeVelodyne, AppliesTheOffsetsOfACalibration)
{
  sensors::VelodyneCalibration calibration = sensors::factoryCalibration(VelodyneModel::vlp16);
  calibration.lasers[0] = {0, 0, 0.5, 0.2, 0.1};  // level, 0.5 m further, 0.2 m up, 0.1 m left
  points::VelodyneInput input;
  input.calibration = &calibration;
  SimulatedVelodyne sensor;
  sensor.rate_dps = 0;
  const auto out = decode(sensor.run(1, sphere(5000)), input);
  EXPECT_NEAR(out.scan.x[0], 10.5, 1e-5);
  EXPECT_NEAR(out.scan.y[0], 0.1, 1e-6);
  EXPECT_NEAR(out.scan.z[0], 0.2, 1e-6);
  const size_t cell = out.image.index(out.scan.ring[0], out.image.columns - 1);
  EXPECT_NEAR(out.image.range_m[cell], std::hypot(10.5, 0.1, 0.2), 1e-5);
  EXPECT_NEAR(out.image.azimuth_rad[cell], std::atan2(0.1, 10.5), 1e-6);
}

TEST(DecodeVelodyne, CountsPointsOfABrokenSensorPoseAsNonfinite)
{
  points::VelodyneInput input;
  input.T_base_sensor.translation().x() = std::numeric_limits<double>::quiet_NaN();
  const auto out = decode(SimulatedVelodyne{}.run(1, sphere(5000)), input);
  EXPECT_EQ(out.scan.size(), 0U);
  EXPECT_EQ(out.rejects.of(Reject::nonfinite), 384U);
}
}  // namespace
}  // namespace traverse::testing
